#include "app/samples/pattern_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/canvas.hpp"
#include "sampling/figures/figures.hpp"

namespace penumbra {
namespace {

constexpr Canvas::Color white = {1, 1, 1}, ink = {0.13f, 0.14f, 0.17f}, grid_color = {0.87f, 0.88f, 0.9f},
                        frame_color = {0.45f, 0.47f, 0.5f}, red = {0.85f, 0.2f, 0.13f}, blue = {0.1f, 0.42f, 0.78f};

constexpr int panel_size = 360;
constexpr double digit_height = 9;
constexpr double highest_power = 3;  // at the top of the curve's panel

struct Panel {
  int left, top;

  PixelRect window() const { return {left, top, left + panel_size, top + panel_size}; }
  // A position in the panel as fractions of its sides, y down.
  Canvas::Point at(double x, double y) const { return {left + x * panel_size, top + y * panel_size}; }
};
constexpr Panel points_panel{34, 24}, picture_panel{454, 24}, curve_panel{874, 24};

void draw_frame(Canvas& canvas, const Panel& panel) {
  // On the pixels just outside, so that the frame is sharp.
  const double l = panel.left - 0.5, t = panel.top - 0.5, r = l + panel_size + 1, b = t + panel_size + 1;
  canvas.curve({{l, t}, {r, t}, {r, b}, {l, b}, {l, t}}, 1, frame_color);
}

void tick_below(Canvas& canvas, const Panel& panel, double x, const std::string& label) {
  const auto [px, py] = panel.at(x, 1);
  const double sharp = std::floor(px) + 0.5;
  canvas.line({sharp, py + 1}, {sharp, py + 5}, 1, frame_color);
  canvas.number({sharp, py + 14}, digit_height, label, ink);
}

void tick_beside(Canvas& canvas, const Panel& panel, double y, const std::string& label) {
  const auto [px, py] = panel.at(0, y);
  const double sharp = std::floor(py) + 0.5;
  canvas.line({px - 5, sharp}, {px - 1, sharp}, 1, frame_color);
  const double width = digit_height * (static_cast<double>(label.size()) - 1.0 / 3);
  canvas.number({px - 9 - width / 2, sharp}, digit_height, label, ink);
}

void draw_cells(Canvas& canvas, const EqualCells& cells) {
  // The lines of cells only a few pixels wide would merge into grey.
  if (cells.rows() > 90) return;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    canvas.line(points_panel.at(x0, y0), points_panel.at(x1, y1), 1, grid_color);
  };
  for (std::size_t row = 0; row < cells.rows(); row++) {
    const double top = cells.top_of_row(row), bottom = cells.top_of_row(row + 1);
    if (row > 0) line(0, top, 1, top);
    for (std::size_t column = 1; column < cells.columns(row); column++) {
      const double x = static_cast<double>(column) / static_cast<double>(cells.columns(row));
      line(x, top, x, bottom);
    }
  }
}

// Calls f with the positions of a point and of its copies around the unit square.
template <typename F>
void at_all_copies(const PlanePoint& p, F&& f) {
  for (int y = -1; y <= 1; y++) {
    for (int x = -1; x <= 1; x++) f(points_panel.at(p.x + x, p.y + y));
  }
}

void draw_points(Canvas& canvas, const PatternPlot& plot) {
  canvas.clip_to(points_panel.window());
  draw_cells(canvas, EqualCells(plot.points.size()));
  at_all_copies(plot.empty.centre,
                [&](Canvas::Point centre) { canvas.ring(centre, plot.empty.radius * panel_size, 1.5, blue); });
  const double radius = std::clamp(0.09 * panel_size / std::sqrt(static_cast<double>(plot.points.size())), 0.6, 4.0);
  const auto dot = [&](const PlanePoint& p, const Canvas::Color& color) {
    at_all_copies(p, [&](Canvas::Point centre) { canvas.disk(centre, radius, color); });
  };
  for (const PlanePoint& p : plot.points) dot(p, ink);
  if (plot.points.size() > 1) {
    dot(plot.points[plot.closest.a], red);
    dot(plot.points[plot.closest.b], red);
  }
  canvas.clip_to_all();
  draw_frame(canvas, points_panel);
  for (const int end : {0, 1}) {
    tick_below(canvas, points_panel, end, fmt::format("{}", end));
    tick_beside(canvas, points_panel, end, fmt::format("{}", end));
  }
}

// The mean grey value of a pixel of the panel, in which every integer frequency has a square.
float grey_at(const Spectrum& spectrum, int x, int y) {
  constexpr int parts = 4;
  const int width = 2 * spectrum.limit() + 1;
  const auto frequency = [&](int pixel, int part) {
    return static_cast<int>((pixel + (part + 0.5) / parts) / panel_size * width) - spectrum.limit();
  };
  double sum = 0;
  for (int j = 0; j < parts; j++) {
    for (int i = 0; i < parts; i++) {
      const int fx = frequency(x, i), fy = frequency(y, j);
      const double power = fx == 0 && fy == 0 ? 0 : spectrum.power(fx, fy);
      sum += power / (1 + power);
    }
  }
  return static_cast<float>(sum / (parts * parts));
}

void draw_picture(Canvas& canvas, const Spectrum& spectrum, double root_n) {
  for (int y = 0; y < panel_size; y++) {
    for (int x = 0; x < panel_size; x++) {
      const float grey = grey_at(spectrum, x, y);
      canvas.pixel(picture_panel.left + x, picture_panel.top + y, {grey, grey, grey});
    }
  }
  draw_frame(canvas, picture_panel);
  const double width = 2.0 * spectrum.limit() + 1;
  for (int k = -4; k <= 4; k++) {
    const double place = 0.5 + k * root_n / width;
    if (place < 0 || place > 1) continue;
    tick_below(canvas, picture_panel, place, fmt::format("{}", k));
    tick_beside(canvas, picture_panel, place, fmt::format("{}", k));
  }
}

void draw_curve(Canvas& canvas, const Spectrum& spectrum, double root_n) {
  const auto place = [&](double frequency, double power) {
    return curve_panel.at(frequency / spectrum.limit(), 1 - power / highest_power);
  };
  canvas.clip_to(curve_panel.window());
  for (int k = 1; k * root_n < spectrum.limit(); k++) {
    canvas.line(place(k * root_n, 0), place(k * root_n, highest_power), 1, grid_color);
  }
  canvas.line(place(0, 1), place(spectrum.limit(), 1), 1.5, frame_color);
  const std::vector<double> radial = spectrum.radial();
  std::vector<Canvas::Point> curve;
  for (std::size_t k = 1; k < radial.size(); k++) {
    // A peak may lie far above the panel.
    curve.push_back(place(static_cast<double>(k), std::min(radial[k], 4 * highest_power)));
  }
  canvas.curve(curve, 2, blue);
  canvas.clip_to_all();
  draw_frame(canvas, curve_panel);
  for (int k = 0; k * root_n <= spectrum.limit(); k++) {
    tick_below(canvas, curve_panel, k * root_n / spectrum.limit(), fmt::format("{}", k));
  }
  for (int power = 0; power <= highest_power; power++) {
    tick_beside(canvas, curve_panel, 1 - power / highest_power, fmt::format("{}", power));
  }
}

}  // namespace

Image draw_pattern(const PatternPlot& plot) {
  Canvas canvas(plot_width, plot_height, white);
  const double root_n = std::sqrt(static_cast<double>(plot.points.size()));
  draw_points(canvas, plot);
  draw_picture(canvas, plot.spectrum, root_n);
  draw_curve(canvas, plot.spectrum, root_n);
  return canvas.take();
}

}  // namespace penumbra
