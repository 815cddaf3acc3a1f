// Where shapes stand: matrices in single precision, which maps keep a shape of its kind, leaves filled from shapes, and
// bounds under a map. What build_world is made of.
#pragma once

#include <cmath>
#include <optional>

#include "geometry/bounds.hpp"
#include "geometry/world.hpp"

namespace penumbra {

inline Placement make_placement(const Affine& m) {
  const Affine inv = inverse(m);
  Placement p{};
  for (int row = 0; row < 3; row++) {
    for (int column = 0; column < 3; column++) {
      p.linear[3 * row + column] = static_cast<float>(m.column[column][row]);
      p.inverse[3 * row + column] = static_cast<float>(inv.column[column][row]);
    }
    p.translation[row] = static_cast<float>(m.translation[row]);
  }
  return p;
}

// The largest sum of absolute values in a row: how much the map can enlarge a coordinate.
inline double row_sum(const Affine& m) { return max_component(abs(m.column[0]) + abs(m.column[1]) + abs(m.column[2])); }

// The factor of a map that is a rotation (or reflection) and one scale for all axes.
inline std::optional<double> uniform_scale(const Affine& m) {
  const double s2 = dot(m.column[0], m.column[0]);
  const double tolerance = 1e-12 * s2;
  for (int i = 0; i < 3; i++) {
    if (std::abs(dot(m.column[i], m.column[i]) - s2) > tolerance) return std::nullopt;
    if (std::abs(dot(m.column[i], m.column[(i + 1) % 3])) > tolerance) return std::nullopt;
  }
  return std::sqrt(s2);
}

inline bool maps_axes_to_axes(const Affine& m) {
  for (int i = 0; i < 3; i++) {
    const double largest = max_component(abs(m.column[i]));
    int entries = 0;
    for (int row = 0; row < 3; row++) entries += std::abs(m.column[i][row]) > 1e-15 * largest;
    if (entries != 1) return false;
  }
  return true;
}

// A scale along y, and one factor for x and z with any turn about y.
inline std::optional<double> uniform_scale_round_y(const Affine& m) {
  const double s2 = dot(m.column[0], m.column[0]);
  const double tolerance = 1e-12 * s2;
  const Vec3 y = m.column[1];
  if (y.x != 0 || y.z != 0 || m.column[0].y != 0 || m.column[2].y != 0) return std::nullopt;
  if (std::abs(dot(m.column[2], m.column[2]) - s2) > tolerance) return std::nullopt;
  if (std::abs(dot(m.column[0], m.column[2])) > tolerance) return std::nullopt;
  return std::sqrt(s2);
}

inline void set3(float* out, Vec3 v) {
  for (int i = 0; i < 3; i++) out[i] = static_cast<float>(v[i]);
}

// The unit normal of a triangle leaf, to the bit as for the triangles of a mesh (geometry/mesh_packet.hpp), so that
// both rooms agree on what is equally far. Divided, not multiplied by an inverse, the normal of an axis-aligned plane
// is exactly one axis, and all triangles in the plane are equally far. Where single precision has no answer, the double
// one.
inline void set_normal(float (&data)[12]) {
  const float ux = data[3] - data[0], uy = data[4] - data[1], uz = data[5] - data[2];
  const float vx = data[6] - data[0], vy = data[7] - data[1], vz = data[8] - data[2];
  const float n[3] = {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
  const float size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int i = 0; i < 3; i++) data[9 + i] = n[i] / size;
  if (std::isnormal(size)) return;
  const Vec3 a{data[0], data[1], data[2]};
  set3(data + 9, normalize(cross(Vec3{data[3], data[4], data[5]} - a, Vec3{data[6], data[7], data[8]} - a)));
}

inline void set_sphere(Leaf& leaf, const Sphere& s) {
  leaf.kind = LeafKind::sphere;
  set3(leaf.data, s.center);
  leaf.data[3] = static_cast<float>(s.radius);
}
inline void set_box(Leaf& leaf, const Box& b) {
  leaf.kind = LeafKind::box;
  set3(leaf.data, b.lo);
  set3(leaf.data + 3, b.hi);
}
inline void set_cylinder(Leaf& leaf, const Cylinder& c) {
  leaf.kind = c.capped ? LeafKind::cylinder : LeafKind::hollow_cylinder;
  const double values[5] = {c.x, c.z, c.radius, c.y_min, c.y_max};
  for (int i = 0; i < 5; i++) leaf.data[i] = static_cast<float>(values[i]);
}

inline Bounds bounds_of(const Sphere& s) { return grow({s.center, s.center}, s.radius); }
inline Bounds bounds_of(const Box& b) { return {b.lo, b.hi}; }
inline Bounds bounds_of(const Cylinder& c) {
  return {{c.x - c.radius, c.y_min, c.z - c.radius}, {c.x + c.radius, c.y_max, c.z + c.radius}};
}

// The tight bounds of an ellipsoid: along each axis, the length of the map's row.
inline Bounds transformed_bounds(const Affine& m, const Sphere& s) {
  Vec3 extent;
  for (int row = 0; row < 3; row++) {
    extent[row] = s.radius * length({m.column[0][row], m.column[1][row], m.column[2][row]});
  }
  const Vec3 center = transform_point(m, s.center);
  return {center - extent, center + extent};
}
template <typename Shape>
Bounds transformed_bounds(const Affine& m, const Shape& s) {
  return transform(m, bounds_of(s));
}

}  // namespace penumbra
