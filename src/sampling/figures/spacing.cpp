#include "sampling/figures/figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <vector>

namespace penumbra {
namespace {

// Sorts the points into square cells, about one point in each; the cells repeat over the whole plane.
class TorusGrid {
 public:
  explicit TorusGrid(std::span<const PlanePoint> points)
      : points_(points),
        side_(std::max(1L, static_cast<long>(std::sqrt(static_cast<double>(points.size()))))),
        cells_(static_cast<std::size_t>(side_ * side_)) {
    for (std::size_t i = 0; i < points.size(); i++) {
      cells_[static_cast<std::size_t>(cell(points[i].y) * side_ + cell(points[i].x))].push_back(i);
    }
  }

  // Calls f(j, dx, dy) for the points j, and their copies, in the ring of cells `ring` cells away from the cell of
  // point i; (dx, dy) is the offset from i to j. No point of the ring is nearer than `distance_of(ring)`.
  template <typename F>
  void visit_ring(std::size_t i, long ring, F&& f) const {
    const long cx = cell(points_[i].x), cy = cell(points_[i].y);
    for (long y = -ring; y <= ring; y++) {
      const long step = std::abs(y) == ring ? 1 : 2 * ring;
      for (long x = -ring; x <= ring; x += step) visit_cell(i, cx + x, cy + y, f);
    }
  }

  double distance_of(long ring) const { return static_cast<double>(ring - 1) / static_cast<double>(side_); }

 private:
  long cell(double x) const { return std::clamp(static_cast<long>(x * static_cast<double>(side_)), 0L, side_ - 1); }

  template <typename F>
  void visit_cell(std::size_t i, long x, long y, F& f) const {
    const long turns_x = (x < 0 ? x - side_ + 1 : x) / side_, turns_y = (y < 0 ? y - side_ + 1 : y) / side_;
    for (const std::size_t j : cells_[static_cast<std::size_t>((y - turns_y * side_) * side_ + x - turns_x * side_)]) {
      f(j, points_[j].x - points_[i].x + static_cast<double>(turns_x),
        points_[j].y - points_[i].y + static_cast<double>(turns_y));
    }
  }

  std::span<const PlanePoint> points_;
  long side_;
  std::vector<std::vector<std::size_t>> cells_;
};

// A convex polygon around the origin.
using Polygon = std::vector<PlanePoint>;

// Keeps the part of the polygon that is nearer to the origin than to (dx, dy).
void cut_by_bisector(Polygon& polygon, double dx, double dy) {
  const double limit = (dx * dx + dy * dy) / 2;
  const auto beyond = [&](const PlanePoint& p) { return p.x * dx + p.y * dy - limit; };
  if (std::none_of(polygon.begin(), polygon.end(), [&](const PlanePoint& p) { return beyond(p) > 0; })) return;
  Polygon rest;
  for (std::size_t i = 0; i < polygon.size(); i++) {
    const PlanePoint& p = polygon[i];
    const PlanePoint& q = polygon[(i + 1) % polygon.size()];
    const double a = beyond(p), b = beyond(q);
    if (a <= 0) rest.push_back(p);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
      const double t = a / (a - b);
      rest.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  polygon = std::move(rest);
}

double squared_length(const PlanePoint& p) { return p.x * p.x + p.y * p.y; }

PlanePoint farthest_corner(const Polygon& polygon) {
  return *std::max_element(polygon.begin(), polygon.end(), [](const PlanePoint& a, const PlanePoint& b) {
    return squared_length(a) < squared_length(b);
  });
}

// The corner of the Voronoi cell of point i that is farthest from it, as an offset. A point more than twice as far away
// cannot cut the cell.
PlanePoint farthest_corner_of_cell(const TorusGrid& grid, std::size_t i) {
  Polygon polygon = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  PlanePoint corner = polygon[0];
  for (long ring = 0; ring < 2 || grid.distance_of(ring) < 2 * std::sqrt(squared_length(corner)); ring++) {
    grid.visit_ring(i, ring, [&](std::size_t, double dx, double dy) {
      const double squared = dx * dx + dy * dy;
      if (squared == 0 || squared >= 4 * squared_length(corner)) return;
      cut_by_bisector(polygon, dx, dy);
      corner = farthest_corner(polygon);
    });
  }
  return corner;
}

double wrapped(double x) { return x - std::floor(x); }

}  // namespace

ClosestPair closest_pair(std::span<const PlanePoint> points) {
  const TorusGrid grid(points);
  ClosestPair best{std::numeric_limits<double>::infinity(), 0, 0};
  for (std::size_t i = 0; i < points.size(); i++) {
    for (long ring = 0; ring < 2 || grid.distance_of(ring) < best.distance; ring++) {
      grid.visit_ring(i, ring, [&](std::size_t j, double dx, double dy) {
        if (j == i && dx == 0 && dy == 0) return;
        const double distance = std::sqrt(dx * dx + dy * dy);
        if (distance < best.distance) best = {distance, i, j};
      });
    }
  }
  return best;
}

EmptyCircle largest_empty_circle(std::span<const PlanePoint> points) {
  const TorusGrid grid(points);
  EmptyCircle largest;
  for (std::size_t i = 0; i < points.size(); i++) {
    const PlanePoint corner = farthest_corner_of_cell(grid, i);
    const double radius = std::sqrt(squared_length(corner));
    if (radius > largest.radius) largest = {radius, {wrapped(points[i].x + corner.x), wrapped(points[i].y + corner.y)}};
  }
  return largest;
}

double largest_possible_distance(std::size_t n) {
  return std::sqrt(2 / (std::numbers::sqrt3 * static_cast<double>(n)));
}

double smallest_possible_circle(std::size_t n) {
  return std::sqrt(2 / (3 * std::numbers::sqrt3 * static_cast<double>(n)));
}

}  // namespace penumbra
