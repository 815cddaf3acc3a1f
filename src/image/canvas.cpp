#include "image/canvas.hpp"

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

// The strokes of the characters on a grid, 0-4 to the right and 0-6 down: two digits per place, spaces between strokes.
constexpr std::string_view drawn_characters = "0123456789.-";
constexpr std::string_view strokes[] = {
    "103041453616050110",          "112026",   "011030414203060646",
    "011030414233 334445361605",   "36300444", "400003334445361605",
    "4130100105163645443304",      "004016",   "1030414233130201 133344453616050413 0110",
    "4233130201103041453616 1605", "1616",     "0343"};

double distance_to_segment(double x, double y, Canvas::Point a, Canvas::Point b) {
  const double dx = b.first - a.first, dy = b.second - a.second;
  const double squared = dx * dx + dy * dy;
  const double along = (x - a.first) * dx + (y - a.second) * dy;
  const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
  return std::hypot(x - a.first - t * dx, y - a.second - t * dy);
}

}  // namespace

Canvas::Canvas(int width, int height, const Color& background)
    : image_(make_image(width, height)), clip_{0, 0, width, height} {
  for (std::size_t i = 0; i < image_.rgb.size(); i++) image_.rgb[i] = background[i % 3];
}

// Calls f with each pixel that may be nearer than `reach`, and the distance of its centre.
template <typename F>
void Canvas::around(Point centre, double reach, F&& f) {
  const double cx = centre.first, cy = centre.second;
  const PixelRect near =
      intersection({static_cast<int>(std::floor(cx - reach - 1)), static_cast<int>(std::floor(cy - reach - 1)),
                    static_cast<int>(std::ceil(cx + reach + 1)), static_cast<int>(std::ceil(cy + reach + 1))},
                   clip_);
  for_pixels(near, [&](int x, int y) { f(x, y, std::hypot(x + 0.5 - cx, y + 0.5 - cy)); });
}

// `depth` is the distance of the pixel's centre from the edge of the shape, positive inside.
void Canvas::blend(int x, int y, const Color& color, double depth) {
  const auto covered = static_cast<float>(std::clamp(0.5 + depth, 0.0, 1.0));
  float* out = &image_.rgb[3 * PixelRect{0, 0, image_.width, image_.height}.index_of(x, y)];
  for (int c = 0; c < 3; c++) out[c] += (color[c] - out[c]) * covered;
}

void Canvas::pixel(int x, int y, const Color& color) { blend(x, y, color, 1); }

void Canvas::disk(Point centre, double radius, const Color& color) {
  around(centre, radius, [&](int x, int y, double distance) { blend(x, y, color, radius - distance); });
}

void Canvas::ring(Point centre, double radius, double width, const Color& color) {
  around(centre, radius + width / 2,
         [&](int x, int y, double distance) { blend(x, y, color, width / 2 - std::abs(distance - radius)); });
}

void Canvas::curve(const std::vector<Point>& points, double width, const Color& color) {
  if (points.empty()) return;
  // First the distance to the nearest segment, so that joints are not painted twice.
  const double reach = width / 2 + 1;
  const auto bounds_of = [&](const Point& a, const Point& b) {
    const auto [left, right] = std::minmax(a.first, b.first);
    const auto [top, bottom] = std::minmax(a.second, b.second);
    return intersection({static_cast<int>(std::floor(left - reach)), static_cast<int>(std::floor(top - reach)),
                         static_cast<int>(std::ceil(right + reach)), static_cast<int>(std::ceil(bottom + reach))},
                        clip_);
  };
  PixelRect all = bounds_of(points[0], points[0]);
  for (const Point& point : points) {
    const PixelRect window = bounds_of(point, point);
    all = {std::min(all.x0, window.x0), std::min(all.y0, window.y0), std::max(all.x1, window.x1),
           std::max(all.y1, window.y1)};
  }
  if (all.x0 >= all.x1 || all.y0 >= all.y1) return;
  std::vector<double> nearest(all.pixel_count(), 1e9);
  for (std::size_t i = 0; i < points.size(); i++) {
    const Point &a = points[i > 0 ? i - 1 : 0], &b = points[i];
    for_pixels(bounds_of(a, b), [&](int x, int y) {
      double& distance = nearest[all.index_of(x, y)];
      distance = std::min(distance, distance_to_segment(x + 0.5, y + 0.5, a, b));
    });
  }
  for_pixels(all, [&](int x, int y) { blend(x, y, color, width / 2 - nearest[all.index_of(x, y)]); });
}

void Canvas::number(Point centre, double height, std::string_view text, const Color& color) {
  const double unit = height / 6, advance = 6 * unit;
  double left = centre.first - (advance * static_cast<double>(text.size()) - 2 * unit) / 2;
  const double top = centre.second - height / 2;
  for (const char character : text) {
    std::vector<Point> stroke;
    const std::size_t which = drawn_characters.find(character);
    const std::string_view places = which == drawn_characters.npos ? "" : strokes[which];
    for (std::size_t i = 0; i < places.size(); i++) {
      if (places[i] == ' ') {
        curve(stroke, 0.13 * height, color);
        stroke.clear();
        continue;
      }
      const double x = places[i] - '0', y = places[++i] - '0';
      stroke.emplace_back(left + x * unit, top + y * unit);
    }
    curve(stroke, 0.13 * height, color);
    left += advance;
  }
}

}  // namespace penumbra
