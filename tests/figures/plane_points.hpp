// Points of the unit square for the tests of the figures.
#pragma once

#include <random>
#include <vector>

#include "sampling/figures/figures.hpp"

namespace penumbra::test {

inline std::vector<PlanePoint> random_points(std::mt19937& random, int n) {
  const auto fraction = [&random] { return static_cast<double>(random()) * 0x1p-32; };
  std::vector<PlanePoint> points;
  for (int i = 0; i < n; i++) {
    const double x = fraction();
    points.push_back({x, fraction()});
  }
  return points;
}

// m x m points in the middle of the squares of a grid.
inline std::vector<PlanePoint> regular_grid(int m) {
  std::vector<PlanePoint> points;
  for (int y = 0; y < m; y++) {
    for (int x = 0; x < m; x++) points.push_back({(x + 0.5) / m, (y + 0.5) / m});
  }
  return points;
}

}  // namespace penumbra::test
