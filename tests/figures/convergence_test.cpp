// Areas below an edge against line-by-line integrals, and the slopes that theory gives for random and jittered points.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/test_scale.hpp"
#include "figures/plane_points.hpp"
#include "sampling/figures/figures.hpp"

namespace penumbra::test {
namespace {

TEST(HalfPlanes, KnownAreas) {
  EXPECT_NEAR(area_in_unit_square({1, 1, 1}), 0.5, 1e-15);
  EXPECT_NEAR(area_in_unit_square({1, 1, 0.5}), 0.125, 1e-15);
  EXPECT_NEAR(area_in_unit_square({-1, -1, -0.5}), 0.875, 1e-15);
  EXPECT_NEAR(area_in_unit_square({1, -2, 0}), 0.75, 1e-15);
  EXPECT_EQ(area_in_unit_square({1, 1, -0.1}), 0);
  EXPECT_NEAR(area_in_unit_square({1, 1, 2.1}), 1, 1e-14);
}

TEST(HalfPlanes, AreasAreIntegrals) {
  std::mt19937 random(1);
  const auto number = [&random] { return static_cast<double>(random()) * 0x1p-31 - 1; };
  for (int round = 0; round < 100; round++) {
    const HalfPlane h{number(), number(), number()};
    constexpr int lines = 2000;
    double sum = 0;
    for (int i = 0; i < lines; i++) {
      const double below = std::clamp((h.c - h.a * (i + 0.5) / lines) / h.b, 0.0, 1.0);
      sum += (h.b > 0 ? below : 1 - below) / lines;
    }
    EXPECT_NEAR(area_in_unit_square(h), sum, 1e-3) << h.a << " " << h.b << " " << h.c;
  }
}

// The variance over R realizations has a relative error of about sqrt(2/R), and the slope through seven of its
// logarithms an error of 0.27 times that: 0.017 for 512 realizations. The limits are six times as wide; the deviation
// of small point counts from the asymptotic laws is less than a third of them.
constexpr int replicates = scaled(512, 128);
constexpr double tolerance = scaled(100, 200) / 1000.0;

TEST(Convergence, OfRandomPoints) {
  std::mt19937 random(2);
  const Convergence slopes = measure_convergence(
      [&](std::size_t count, int) { return random_points(random, static_cast<int>(count)); }, replicates);
  EXPECT_NEAR(slopes.smooth, -1, tolerance);
  EXPECT_NEAR(slopes.edges, -1, tolerance);
}

TEST(Convergence, OfJitteredPoints) {
  std::mt19937 random(3);
  const auto jittered = [&](std::size_t count, int) {
    std::vector<PlanePoint> points = random_points(random, static_cast<int>(count));
    const EqualCells cells(count);
    for (std::size_t row = 0; row < cells.rows(); row++) {
      const double top = cells.top_of_row(row), height = cells.top_of_row(row + 1) - top;
      for (std::size_t column = 0; column < cells.columns(row); column++) {
        PlanePoint& p = points[cells.first_of_row(row) + column];
        p = {(static_cast<double>(column) + p.x) / static_cast<double>(cells.columns(row)), top + p.y * height};
      }
    }
    return points;
  };
  const Convergence slopes = measure_convergence(jittered, replicates);
  EXPECT_NEAR(slopes.smooth, -2, tolerance);
  EXPECT_NEAR(slopes.edges, -1.5, tolerance);
}

}  // namespace
}  // namespace penumbra::test
