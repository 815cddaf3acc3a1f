// Distances and empty circles on the torus against known lattices and against all pairs and triples.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/test_scale.hpp"
#include "figures/plane_points.hpp"
#include "sampling/figures/figures.hpp"

namespace penumbra::test {
namespace {

double torus_distance(const PlanePoint& a, const PlanePoint& b) {
  const auto along = [](double d) { return std::abs(d - std::round(d)); };
  return std::hypot(along(a.x - b.x), along(a.y - b.y));
}

double nearest_point(const std::vector<PlanePoint>& points, const PlanePoint& point) {
  double nearest = 2;
  for (const PlanePoint& p : points) nearest = std::min(nearest, torus_distance(p, point));
  return nearest;
}

double smallest_of_all_pairs(const std::vector<PlanePoint>& points) {
  double smallest = 1;
  for (std::size_t i = 0; i < points.size(); i++) {
    for (std::size_t j = 0; j < i; j++) smallest = std::min(smallest, torus_distance(points[i], points[j]));
  }
  return smallest;
}

// The largest circle through three points, or their copies, with none inside.
double largest_of_all_triples(const std::vector<PlanePoint>& points) {
  std::vector<PlanePoint> all;
  for (int y = -1; y <= 1; y++) {
    for (int x = -1; x <= 1; x++) {
      for (const PlanePoint& p : points) all.push_back({p.x + x, p.y + y});
    }
  }
  double largest = 0;
  for (std::size_t i = 0; i < all.size(); i++) {
    for (std::size_t j = 0; j < i; j++) {
      for (std::size_t k = 0; k < j; k++) {
        const double bx = all[j].x - all[i].x, by = all[j].y - all[i].y;
        const double cx = all[k].x - all[i].x, cy = all[k].y - all[i].y;
        const double cross = 2 * (bx * cy - by * cx);
        if (std::abs(cross) < 1e-12) continue;
        const double b = bx * bx + by * by, c = cx * cx + cy * cy;
        const PlanePoint way{(cy * b - by * c) / cross, (bx * c - cx * b) / cross};
        const double radius = std::hypot(way.x, way.y);
        if (radius <= largest || radius > 0.75) continue;
        if (nearest_point(points, {all[i].x + way.x, all[i].y + way.y}) >= radius - 1e-9) largest = radius;
      }
    }
  }
  return largest;
}

TEST(Spacing, OfARegularGrid) {
  for (const int m : {1, 2, 3, 8, 50}) {
    const std::vector<PlanePoint> points = regular_grid(m);
    EXPECT_NEAR(closest_pair(points).distance, 1.0 / m, 1e-12);
    const EmptyCircle circle = largest_empty_circle(points);
    EXPECT_NEAR(circle.radius, std::sqrt(0.5) / m, 1e-12);
    // Its centre is a corner of the grid.
    EXPECT_NEAR(circle.centre.x * m, std::round(circle.centre.x * m), 1e-9);
    EXPECT_NEAR(circle.centre.y * m, std::round(circle.centre.y * m), 1e-9);
  }
}

TEST(Spacing, GoesAroundTheEdges) {
  const std::vector<PlanePoint> points = {{0.01, 0.5}, {0.5, 0.5}, {0.99, 0.5}};
  const ClosestPair pair = closest_pair(points);
  EXPECT_NEAR(pair.distance, 0.02, 1e-12);
  EXPECT_EQ(std::min(pair.a, pair.b), 0u);
  EXPECT_EQ(std::max(pair.a, pair.b), 2u);
}

// Three points in a row: the largest circle touches the two that are far apart, and a copy above.
TEST(Spacing, OfAHandMadeSet) {
  const std::vector<PlanePoint> points = {{0.1, 0.5}, {0.3, 0.5}, {0.5, 0.5}};
  const EmptyCircle circle = largest_empty_circle(points);
  EXPECT_NEAR(circle.radius, std::hypot(0.3, 0.5), 1e-12);
  EXPECT_NEAR(circle.centre.x, 0.8, 1e-12);
  EXPECT_LT(torus_distance({0, circle.centre.y}, {0, 0}), 1e-9);
}

TEST(Spacing, PointsOnEachOther) {
  const std::vector<PlanePoint> points = {{0.25, 0.75}, {0.5, 0.5}, {0.25, 0.75}, {0.5, 0.5}};
  EXPECT_EQ(closest_pair(points).distance, 0);
  EXPECT_NEAR(largest_empty_circle(points).radius, largest_of_all_triples({points[0], points[1]}), 1e-12);
}

TEST(Spacing, AgreesWithAllPairsAndTriples) {
  std::mt19937 random(1);
  for (int round = 0; round < scaled(24, 4); round++) {
    const std::vector<PlanePoint> points = random_points(random, 1 + round % 12);
    EXPECT_NEAR(closest_pair(points).distance, smallest_of_all_pairs(points), 1e-12);
    const EmptyCircle circle = largest_empty_circle(points);
    EXPECT_NEAR(circle.radius, largest_of_all_triples(points), 1e-9) << points.size();
    EXPECT_NEAR(nearest_point(points, circle.centre), circle.radius, 1e-12);
  }
}

// Clustered points too: wide cells beside narrow ones.
TEST(Spacing, NoCircleIsLarger) {
  std::mt19937 random(2);
  for (const int n : {100, 1000}) {
    for (const double squeeze : {1.0, 0.3}) {
      std::vector<PlanePoint> points = random_points(random, n);
      for (PlanePoint& p : points) p.x *= squeeze;
      EXPECT_NEAR(closest_pair(points).distance, smallest_of_all_pairs(points), 1e-12);
      const EmptyCircle circle = largest_empty_circle(points);
      EXPECT_NEAR(nearest_point(points, circle.centre), circle.radius, 1e-12);
      for (int i = 0; i < scaled(10000, 1000); i++) {
        ASSERT_LE(nearest_point(points, random_points(random, 1)[0]), circle.radius + 1e-12);
      }
    }
  }
}

TEST(Spacing, NothingBeatsTheHexagonalLattice) {
  std::mt19937 random(3);
  for (const int n : {1, 2, 5, 40}) {
    for (const std::vector<PlanePoint>& points : {random_points(random, n), regular_grid(n)}) {
      EXPECT_LE(closest_pair(points).distance, largest_possible_distance(points.size()));
      EXPECT_GE(largest_empty_circle(points).radius, smallest_possible_circle(points.size()));
    }
  }
  // 22 x 26 points in shifted rows, nearly equilateral triangles: 26 sqrt(3) / 2 = 22.5 is nearly 22.
  std::vector<PlanePoint> lattice;
  for (int row = 0; row < 26; row++) {
    for (int i = 0; i < 22; i++) lattice.push_back({(i + row % 2 * 0.5 + 0.1) / 22, (row + 0.1) / 26});
  }
  EXPECT_GT(closest_pair(lattice).distance, 0.97 * largest_possible_distance(lattice.size()));
  EXPECT_LT(largest_empty_circle(lattice).radius, 1.03 * smallest_possible_circle(lattice.size()));
}

}  // namespace
}  // namespace penumbra::test
