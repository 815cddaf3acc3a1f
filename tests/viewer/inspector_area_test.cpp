#include "viewer/inspector_area.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace penumbra {
namespace {

// How much of `a` lies in `b`, in pixels.
int shared(const WindowArea& a, const WindowArea& b) {
  const int width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
  const int height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
  return std::max(width, 0) * std::max(height, 0);
}

TEST(InspectorArea, CoversAtMostAThirdAndNotThePixel) {
  for (const WindowArea& area :
       {WindowArea{0, 0, 980, 730}, WindowArea{0, 0, 180, 290}, WindowArea{0, 0, 1600, 1000}}) {
    for (const auto& [width, height] : {std::pair{120, 90}, {600, 400}, {3000, 2000}, {300, 2000}, {4000, 10}}) {
      for (const int zoom_steps : {0, 3}) {
        PictureView view;
        view.set_area(area);
        view.set_picture_size(width, height);
        view.zoom(zoom_steps, {100, 100});
        const int seen = shared(view.picture(), area);
        const int top = std::max(view.picture().y, 0);
        const int bottom = std::min(view.picture().y + view.picture().height, area.height);
        for (const double share : {0.02, 0.3, 0.49, 0.51, 0.9}) {
          const PlaceInWindow pixel{100, top + share * (bottom - top)};
          const WindowArea inspector = inspector_area(view, pixel, 10, 330);
          EXPECT_LE(3 * shared(inspector, view.picture()), seen) << area.width << ' ' << width << ' ' << share;
          EXPECT_TRUE(pixel.y < inspector.y || pixel.y >= inspector.y + inspector.height) << share;
          EXPECT_LE(inspector.height, 330);
        }
      }
    }
  }
}

TEST(InspectorArea, UsesTheRoomBesideThePicture) {
  PictureView view;
  view.set_area({0, 0, 980, 730});
  view.set_picture_size(600, 400);  // from 165 to 565
  EXPECT_EQ(inspector_area(view, {300, 200}, 10, 1000).y, 565 - 133);
  EXPECT_EQ(inspector_area(view, {300, 500}, 10, 1000).height, 165 + 133 - 10);
}

}  // namespace
}  // namespace penumbra
