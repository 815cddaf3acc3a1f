// Star discrepancies against known values and against all boxes tried in turn.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "base/test_scale.hpp"
#include "figures/plane_points.hpp"
#include "sampling/figures/figures.hpp"
#include "sampling/statistics.hpp"

namespace penumbra::test {
namespace {

// Warnock's formula as written.
double warnock(const std::vector<PlanePoint>& points) {
  const auto n = static_cast<double>(points.size());
  double single = 0, pairs = 0;
  for (const PlanePoint& p : points) {
    single += (1 - p.x * p.x) * (1 - p.y * p.y);
    for (const PlanePoint& q : points) pairs += (1 - std::max(p.x, q.x)) * (1 - std::max(p.y, q.y));
  }
  return std::sqrt(1.0 / 9 - single / (2 * n) + pairs / (n * n));
}

// All boxes whose upper sides pass through points or end at 1, with and without the points on the sides.
double every_box(const std::vector<PlanePoint>& points) {
  std::vector<double> xs = {1}, ys = {1};
  for (const PlanePoint& p : points) {
    xs.push_back(p.x);
    ys.push_back(p.y);
  }
  double worst = 0;
  for (const double x : xs) {
    for (const double y : ys) {
      double open = 0, closed = 0;
      for (const PlanePoint& p : points) {
        open += p.x < x && p.y < y ? 1 : 0;
        closed += p.x <= x && p.y <= y ? 1 : 0;
      }
      const auto n = static_cast<double>(points.size());
      worst = std::max({worst, x * y - open / n, closed / n - x * y});
    }
  }
  return worst;
}

TEST(Discrepancy, OfOnePoint) {
  for (const auto& [x, y] : {std::pair(0.5, 0.5), {0.0, 0.0}, {0.2, 0.9}, {0.99, 0.01}}) {
    const std::vector<PlanePoint> points = {{x, y}};
    const double expected = 1.0 / 9 - (1 - x * x) * (1 - y * y) / 2 + (1 - x) * (1 - y);
    EXPECT_NEAR(l2_star_discrepancy(points), std::sqrt(expected), 1e-15);
    // The box up to the point holds everything, the widest and the highest box beside it nothing.
    EXPECT_NEAR(star_discrepancy(points), std::max({1 - x * y, x, y}), 1e-15);
  }
}

// The mean square over boxes, from a million boxes.
TEST(Discrepancy, IsTheMeanSquareOverBoxes) {
  const std::vector<PlanePoint> points = {{0.1, 0.7}, {0.35, 0.2}, {0.6, 0.95}, {0.62, 0.21}, {0.9, 0.4}};
  constexpr int side = 1000;
  double sum = 0;
  for (int i = 0; i < side; i++) {
    for (int j = 0; j < side; j++) {
      const double x = (i + 0.5) / side, y = (j + 0.5) / side;
      double inside = 0;
      for (const PlanePoint& p : points) inside += p.x < x && p.y < y ? 1 : 0;
      const double difference = inside / static_cast<double>(points.size()) - x * y;
      sum += difference * difference / (double{side} * side);
    }
  }
  // No coordinate lies on a midpoint, so the error is only that of smooth pieces, of second order.
  EXPECT_NEAR(l2_star_discrepancy(points), std::sqrt(sum), 1e-5);
}

// m x m points in the middle of their cells: the box up to the last point holds all of them.
TEST(Discrepancy, OfARegularGrid) {
  for (const int m : {1, 2, 3, 8, 20}) {
    const double last = 1 - 0.5 / m;
    EXPECT_NEAR(star_discrepancy(regular_grid(m)), 1 - last * last, 1e-12) << m;
  }
}

TEST(Discrepancy, AgreesWithTheFormulasAsWritten) {
  std::mt19937 random(1);
  for (const int n : {1, 2, 3, 10, 31, 64}) {
    for (const int levels : {4, 1 << 20}) {  // four levels: many equal coordinates, and coincident points
      std::vector<PlanePoint> points = random_points(random, n);
      for (PlanePoint& p : points) p = {std::floor(p.x * levels) / levels, std::floor(p.y * levels) / levels};
      EXPECT_NEAR(l2_star_discrepancy(points), warnock(points), 1e-9) << n << " " << levels;
      EXPECT_NEAR(star_discrepancy(points), every_box(points), 1e-12) << n << " " << levels;
    }
  }
}

// The square of the L2 discrepancy of random points is 5 / (36 n) on average.
TEST(Discrepancy, OfRandomPoints) {
  std::mt19937 random(2);
  constexpr int n = 64, rounds = scaled(4000, 500);
  double sum = 0, squares = 0;
  for (int round = 0; round < rounds; round++) {
    const double squared = std::pow(l2_star_discrepancy(random_points(random, n)), 2);
    sum += squared;
    squares += squared * squared;
  }
  const double mean = sum / rounds;
  EXPECT_NEAR(mean, 5.0 / (36 * n), normal_limit(2) * std::sqrt((squares / rounds - mean * mean) / rounds));
}

}  // namespace
}  // namespace penumbra::test
