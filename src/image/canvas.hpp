// Draws the program's own plots: smooth-edged shapes and numbers on an image. How much of the colour a pixel takes
// depends on its distance from the edge of the shape, over a ramp one pixel wide.
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.hpp"

namespace penumbra {

// Places are in pixels from the top-left corner of the picture, so pixel (0, 0) has its centre at (0.5, 0.5).
class Canvas {
 public:
  using Color = std::array<float, 3>;
  using Point = std::pair<double, double>;

  Canvas(int width, int height, const Color& background);

  // From now on, nothing outside this rectangle of whole pixels is drawn.
  void clip_to(const PixelRect& window) { clip_ = window; }
  void clip_to_all() { clip_ = {0, 0, image_.width, image_.height}; }

  void pixel(int x, int y, const Color& color);
  void disk(Point centre, double radius, const Color& color);
  void ring(Point centre, double radius, double width, const Color& color);
  void line(Point from, Point to, double width, const Color& color) { curve({from, to}, width, color); }
  // Lines from each place to the next, with round joints, as one shape.
  void curve(const std::vector<Point>& points, double width, const Color& color);

  // Digits, `.` and `-`, `height` pixels high, with the middle of the text at `centre`; other characters are blank.
  void number(Point centre, double height, std::string_view text, const Color& color);

  Image take() { return std::move(image_); }

 private:
  void blend(int x, int y, const Color& color, double depth);
  template <typename F>
  void around(Point centre, double reach, F&& f);

  Image image_;
  PixelRect clip_;
};

}  // namespace penumbra
