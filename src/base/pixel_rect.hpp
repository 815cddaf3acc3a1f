// Pixels of a picture, and rectangles of them: a crop, a tile, the data window of a file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace penumbra {

inline constexpr int most_pixels = 1 << 28;  // in a picture, rendered or read

// Counted from the top left of the picture.
struct Pixel {
  std::uint32_t x, y;
};

// Pixels x0 <= x < x1, y0 <= y < y1, counted from the top left of the full picture.
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  std::size_t pixel_count() const { return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()); }
  bool contains(int x, int y) const { return x >= x0 && y >= y0 && x < x1 && y < y1; }

  // The number of a pixel, row by row from the top left of the rectangle.
  std::size_t index_of(int x, int y) const {
    return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(x - x0);
  }
  std::size_t index_of(Pixel pixel) const { return index_of(static_cast<int>(pixel.x), static_cast<int>(pixel.y)); }

  bool operator==(const PixelRect&) const = default;
};

// The intersection of two rectangles; if it is empty, its width or height is not above 0.
inline PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// Calls `visit(x, y)` for each pixel, row by row.
template <class Visit>
void for_pixels(const PixelRect& rect, const Visit& visit) {
  for (int y = rect.y0; y < rect.y1; y++) {
    for (int x = rect.x0; x < rect.x1; x++) visit(x, y);
  }
}

}  // namespace penumbra
