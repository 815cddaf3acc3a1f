// Affine maps of shapes: which of them keep what, and how much they enlarge.
#pragma once

#include <cmath>
#include <optional>

#include "base/vec.hpp"

namespace penumbra {

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

}  // namespace penumbra
