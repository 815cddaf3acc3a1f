// Axis-aligned bounding boxes in double precision.
#pragma once

#include <limits>

#include "base/vec.hpp"

namespace penumbra {

struct Bounds {
  Vec3 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::infinity()};
  Vec3 hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()};
};

inline bool is_empty(const Bounds& b) { return !(b.lo.x <= b.hi.x); }

inline Bounds include(Bounds b, Vec3 p) { return {min(b.lo, p), max(b.hi, p)}; }
inline Bounds include(Bounds a, const Bounds& b) { return {min(a.lo, b.lo), max(a.hi, b.hi)}; }
inline Bounds grow(const Bounds& b, double by) { return {b.lo - Vec3{by, by, by}, b.hi + Vec3{by, by, by}}; }
inline Bounds shift(const Bounds& b, Vec3 by) { return {b.lo + by, b.hi + by}; }

// The largest coordinate in absolute value; 0 for empty bounds.
inline double magnitude(const Bounds& b) {
  return is_empty(b) ? 0 : std::max(max_component(abs(b.lo)), max_component(abs(b.hi)));
}

// Half the surface area, the measure of the surface area heuristic.
inline double half_area(const Bounds& b) {
  const Vec3 d = b.hi - b.lo;
  return is_empty(b) ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
}

// The bounds of the transformed box.
inline Bounds transform(const Affine& m, const Bounds& b) {
  if (is_empty(b)) return b;
  Bounds result;
  for (int corner = 0; corner < 8; corner++) {
    const Vec3 p{corner & 1 ? b.hi.x : b.lo.x, corner & 2 ? b.hi.y : b.lo.y, corner & 4 ? b.hi.z : b.lo.z};
    result = include(result, transform_point(m, p));
  }
  return result;
}

}  // namespace penumbra
