#include "language/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace penumbra {
namespace {

struct Point {
  double x, y;
};

// Twice the area of a triangle; positive if it runs counterclockwise.
double turn(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

double span(Point a, Point b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y); }

// The corners as seen along an axis, so that they run counterclockwise.
class View {
 public:
  View(const TriangleStore& store, std::span<const std::uint32_t> corners) : store_(store), corners_(corners) {
    const Vec3 origin = position(0);
    Vec3 area, least, most, last = position(1) - origin;
    for (std::size_t i = 2; i < corners.size(); i++) {
      const Vec3 next = position(i) - origin, part = cross(last, next);
      area = area + part;
      least = min(least, part);
      most = max(most, part);
      last = next;
    }
    const Vec3 size = abs(area);
    const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
    x_ = (axis + 1) % 3;
    y_ = (axis + 2) % 3;
    if (area[axis] < 0) std::swap(x_, y_);
    is_fan_ = area == Vec3{} || (area[axis] < 0 ? most[axis] : -least[axis]) <= 0 || is_fan_but_for_rounding();
  }

  // Whether no triangle of the fan from the first corner turns over.
  bool is_fan() const { return is_fan_; }

  Point operator[](std::size_t i) const {
    const float* p = &store_.vertices[3 * std::size_t{corners_[i]}];
    return {p[x_], p[y_]};
  }

  // How far turn(a, b, p) can be from zero while p, rounded to single precision, is on a side of the triangle.
  double rounding(Point a, Point b, Point c) const { return rounding_ * (span(a, b) + span(b, c) + span(c, a)); }

 private:
  Vec3 position(std::size_t i) const {
    const float* p = &store_.vertices[3 * std::size_t{corners_[i]}];
    return {p[0], p[1], p[2]};
  }

  bool is_fan_but_for_rounding() {
    double largest = 0;
    for (std::size_t i = 0; i < corners_.size(); i++) largest = std::max(largest, max_component(abs(position(i))));
    rounding_ = largest / (1 << 23);
    const Point a = (*this)[0];
    for (std::size_t i = 1; i + 1 < corners_.size(); i++) {
      const Point b = (*this)[i], c = (*this)[i + 1];
      if (turn(a, b, c) < -rounding(a, b, c)) return false;
    }
    return true;
  }

  const TriangleStore& store_;
  std::span<const std::uint32_t> corners_;
  int x_ = 0, y_ = 1;
  bool is_fan_ = false;
  double rounding_ = 0;
};

// Whether a segment passes through the inside of a triangle that is smaller by `margin` on each side.
bool enters(Point p, Point q, Point a, Point b, Point c, double margin) {
  double begin = 0, end = 1;
  const Point corner[] = {a, b, c, a};
  for (int side = 0; side < 3; side++) {
    const double at_p = turn(corner[side], corner[side + 1], p) - margin;
    const double at_q = turn(corner[side], corner[side + 1], q) - margin;
    if (at_p <= 0 && at_q <= 0) return false;
    if (at_p < 0) begin = std::max(begin, at_p / (at_p - at_q));
    if (at_q < 0) end = std::min(end, at_p / (at_p - at_q));
  }
  return begin < end;
}

// The outline that is left while ears are cut off.
class Outline {
 public:
  explicit Outline(const View& view, std::size_t count) : view_(view) {
    for (std::size_t i = 0; i < count; i++) ring_.push_back({view[i], static_cast<std::uint32_t>(i)});
    for (std::size_t i = 0; i < count; i++) judge(i);
  }

  // Calls `take` with the corners of each triangle. Ears without area come last: their middle corners are in the way of
  // nothing, but other triangles can use them.
  template <typename Take>
  void cut(const Take& take) {
    while (ring_.size() > 3) {
      auto ear = std::ranges::find(ring_, Ear::yes, &Corner::ear);
      if (ear == ring_.end()) ear = std::ranges::find(ring_, Ear::flat, &Corner::ear);
      if (ear == ring_.end()) break;  // it crosses itself
      const auto i = static_cast<std::size_t>(ear - ring_.begin());
      take(ring_[before(i)].number, ear->number, ring_[after(i)].number);
      ring_.erase(ear);
      judge(before(i));
      judge(i % ring_.size());
    }
    for (std::size_t i = 1; i + 1 < ring_.size(); i++) take(ring_[0].number, ring_[i].number, ring_[i + 1].number);
  }

 private:
  enum class Ear : std::uint8_t { no, flat, yes };
  struct Corner {
    Point at;
    std::uint32_t number;
    Ear ear = Ear::no;
  };

  std::size_t before(std::size_t i) const { return i == 0 ? ring_.size() - 1 : i - 1; }
  std::size_t after(std::size_t i) const { return i + 1 == ring_.size() ? 0 : i + 1; }

  // An ear turns left, and no side of the outline passes through it.
  void judge(std::size_t i) {
    const Point a = ring_[before(i)].at, b = ring_[i].at, c = ring_[after(i)].at;
    const double size = turn(a, b, c), margin = view_.rounding(a, b, c);
    ring_[i].ear = size > margin ? Ear::yes : size < -margin ? Ear::no : Ear::flat;
    if (ring_[i].ear != Ear::yes) return;
    const double left = std::min({a.x, b.x, c.x}), right = std::max({a.x, b.x, c.x});
    const double low = std::min({a.y, b.y, c.y}), high = std::max({a.y, b.y, c.y});
    Point p = ring_.back().at;
    for (const Corner& corner : ring_) {
      const Point q = corner.at;
      const bool outside = std::max(p.x, q.x) <= left || std::min(p.x, q.x) >= right || std::max(p.y, q.y) <= low ||
                           std::min(p.y, q.y) >= high;
      if (!outside && enters(p, q, a, b, c, margin)) {
        ring_[i].ear = Ear::no;
        return;
      }
      p = q;
    }
  }

  const View& view_;
  std::vector<Corner> ring_;
};

}  // namespace

std::string append_polygon(TriangleStore& store, std::span<const std::uint32_t> corners,
                           std::span<const std::uint32_t> normals) {
  constexpr std::size_t most_triangles = std::numeric_limits<std::uint32_t>::max();
  if (store.triangle_count() + corners.size() - 2 > most_triangles) return "there are too many triangles";
  const auto take = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t i : {a, b, c}) {
      store.indices.push_back(corners[i]);
      if (!normals.empty()) store.normal_numbers.push_back(normals[i]);
    }
  };
  if (corners.size() == 3) return take(0, 1, 2), std::string();
  const View view(store, corners);
  if (view.is_fan()) {
    for (std::size_t i = 1; i + 1 < corners.size(); i++) take(0, i, i + 1);
  } else if (corners.size() <= most_concave_corners) {
    Outline(view, corners.size()).cut(take);
  } else {
    return fmt::format("this face has {} corners and is not convex; then at most {} can be split", corners.size(),
                       most_concave_corners);
  }
  return {};
}

}  // namespace penumbra
