// Double-precision vectors and affine maps for everything that is prepared once: parsing, transforms, bounds.
// The ray tracing itself works on packets of single-precision lanes (base/lanes.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace penumbra {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  bool operator==(const Vec3&) const = default;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3 operator*(double s, Vec3 a) { return a * s; }
inline Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 min(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
inline Vec3 max(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }
inline Vec3 abs(Vec3 a) { return {std::abs(a.x), std::abs(a.y), std::abs(a.z)}; }
inline double max_component(Vec3 a) { return std::max(a.x, std::max(a.y, a.z)); }
// a times 2^exponent.
inline Vec3 scalbn(Vec3 a, int exponent) {
  return {std::scalbn(a.x, exponent), std::scalbn(a.y, exponent), std::scalbn(a.z, exponent)};
}
// a times the power of two that brings its largest component to 1 or more, below 2, where squares neither overflow nor
// underflow; zero stays zero.
inline Vec3 near_unit(Vec3 a) {
  const double largest = max_component(abs(a));
  return largest > 0 && std::isfinite(largest) ? scalbn(a, -std::ilogb(largest)) : a;
}
// The unit vector along a, whatever its length; NaN where a is zero.
inline Vec3 normalize(Vec3 a) {
  const Vec3 scaled = near_unit(a);
  return scaled / length(scaled);
}
inline bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

// Rounds to single precision, which is what packets work with.
inline void set3(float (&out)[3], Vec3 v) {
  for (int i = 0; i < 3; i++) out[i] = static_cast<float>(v[i]);
}

// An affine map p -> L p + t, with L held as its three columns.
struct Affine {
  std::array<Vec3, 3> column{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 translation;

  bool operator==(const Affine&) const = default;
};

inline Vec3 transform_vector(const Affine& m, Vec3 v) {
  return m.column[0] * v.x + m.column[1] * v.y + m.column[2] * v.z;
}
inline Vec3 transform_point(const Affine& m, Vec3 p) { return transform_vector(m, p) + m.translation; }

// The map that applies `inner` first, then `outer`.
inline Affine operator*(const Affine& outer, const Affine& inner) {
  Affine product;
  for (int i = 0; i < 3; i++) product.column[i] = transform_vector(outer, inner.column[i]);
  product.translation = transform_point(outer, inner.translation);
  return product;
}

inline double determinant(const Affine& m) { return dot(m.column[0], cross(m.column[1], m.column[2])); }

// Along a normal of what the map makes of a surface, on the same side: the inverse transpose times a positive factor.
inline Vec3 transform_normal(const Affine& m, Vec3 n) {
  const Vec3 along = cross(m.column[1], m.column[2]) * n.x + cross(m.column[2], m.column[0]) * n.y +
                     cross(m.column[0], m.column[1]) * n.z;
  return determinant(m) < 0 ? -along : along;
}

// The inverse map. The determinant must not be zero.
inline Affine inverse(const Affine& m) {
  const double det = determinant(m);
  const Vec3 r0 = cross(m.column[1], m.column[2]) / det;
  const Vec3 r1 = cross(m.column[2], m.column[0]) / det;
  const Vec3 r2 = cross(m.column[0], m.column[1]) / det;
  Affine result;
  result.column = {Vec3{r0.x, r1.x, r2.x}, Vec3{r0.y, r1.y, r2.y}, Vec3{r0.z, r1.z, r2.z}};
  result.translation = -transform_vector(result, m.translation);
  return result;
}

inline Affine translation(Vec3 t) {
  Affine m;
  m.translation = t;
  return m;
}

inline Affine scaling(Vec3 s) { return {{Vec3{s.x, 0, 0}, Vec3{0, s.y, 0}, Vec3{0, 0, s.z}}, {}}; }

// Right-handed rotation by `degrees` about `axis` (any length but zero), by Rodrigues' formula.
inline Affine rotation(double degrees, Vec3 axis) {
  const Vec3 k = normalize(axis);
  const double angle = degrees * std::numbers::pi / 180;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  const auto rotate = [&](Vec3 v) { return v * c + cross(k, v) * s + k * (dot(k, v) * (1 - c)); };
  return {{rotate({1, 0, 0}), rotate({0, 1, 0}), rotate({0, 0, 1})}, {}};
}

}  // namespace penumbra
