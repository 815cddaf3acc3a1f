#include "viewer/inspector_area.hpp"

#include <algorithm>

namespace penumbra {

WindowArea inspector_area(const PictureView& view, PlaceInWindow pixel, int margin, int most) {
  const WindowArea& area = view.area();
  const WindowArea picture = view.picture();
  const int top = std::max(picture.y, area.y);
  const int bottom = std::min(picture.y + picture.height, area.y + area.height);
  const int third = std::max(bottom - top, 0) / 3;
  const bool below = pixel.y < (top + bottom) / 2.0;
  const int free = below ? area.y + area.height - bottom : top - area.y;
  const int height = std::clamp(free + third - margin, 1, std::max(most, 1));
  const int y = below ? area.y + area.height - margin - height : area.y + margin;
  return {area.x + margin, y, std::max(area.width - 2 * margin, 1), height};
}

}  // namespace penumbra
