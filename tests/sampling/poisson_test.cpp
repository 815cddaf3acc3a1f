// `poisson` is a true, maximal Poisson disk pattern at every count: no two points are nearer than the table's distance,
// and no place is farther than it from all points. Checked exactly, on tables and on what packets draw from them; the
// checks notice sets that are not maximal.

#include <gtest/gtest.h>

#include "base/test_scale.hpp"
#include "sampling/points.hpp"
#include "sampling/sample_tables.hpp"
#include "sampling/strata_checks.hpp"
#include "sampling/torus.hpp"

namespace penumbra::test {
namespace {

std::vector<TorusPoint> points_of_table(const PoissonTable& table) {
  std::vector<TorusPoint> points;
  for (std::uint32_t tile = 0; tile < table.tiles * table.tiles; tile++) {
    for (std::uint32_t i = 0; i < table.size; i++) {
      points.push_back({(tile % table.tiles + double{table.u[i]}) / table.tiles,
                        (tile / table.tiles + double{table.v[i]}) / table.tiles});
    }
  }
  return points;
}

std::vector<TorusPoint> drawn(std::uint32_t count, int x, int y, Dimensions dimensions, std::uint32_t seed) {
  const Points p = points_of(sampling_frame(Pattern::poisson, count, seed), x, y, dimensions, count);
  std::vector<TorusPoint> points;
  for (std::size_t i = 0; i < count; i++) points.push_back({p.u[i], p.v[i]});
  return points;
}

void expect_maximal(std::uint32_t count, std::uint32_t seed) {
  const PoissonTable table = make_poisson_table(count, seed);
  ASSERT_EQ(table.count, count);
  ASSERT_EQ(table.u.size(), table.size);
  ASSERT_EQ(table.v.size(), table.size);
  for (std::uint32_t i = 0; i < table.size; i++) {
    ASSERT_TRUE(table.u[i] >= 0 && table.u[i] < 1 && table.v[i] >= 0 && table.v[i] < 1);
  }
  const std::vector<TorusPoint> points = points_of_table(table);
  EXPECT_GE(least_distance(points), double{table.distance}) << count << " points, seed " << seed;
  EXPECT_TRUE(is_covered(points, table.distance)) << count << " points, seed " << seed;
  // As dense as random maximal sets are (0.83 for many points), far from a hexagonal grid (1.07).
  if (count > 8) {
    const double density = table.distance * std::sqrt(static_cast<double>(points.size()));
    EXPECT_GT(density, 0.75) << count;
    EXPECT_LT(density, 0.95) << count;
  }
}

TEST(Poisson, TablesAreMaximal) {
  for (std::uint32_t count = 1; count <= 40; count++) {
    for (std::uint32_t seed = 0; seed < 4; seed++) expect_maximal(count, seed);
  }
  for (const std::uint32_t count : {49u, 64u, 81u, 100u, 121u, 128u, 255u, 256u, 257u}) expect_maximal(count, 5);
  if (slow_build) return;
  for (const std::uint32_t count : {400u, 512u, 777u, 988u, 1000u, 1023u, 1024u}) expect_maximal(count, 6);
}

// Takes half a minute: run it with --gtest_also_run_disabled_tests when the tables change.
TEST(Poisson, DISABLED_TablesAreMaximalAtEveryCount) {
  for (std::uint32_t count = 1; count <= largest_poisson_tile; count++) expect_maximal(count, count % 3);
}

// Tiles side by side are one set, with at least as many points as requested and fewer than one more per tile.
TEST(Poisson, TilesMakeLargeSets) {
  for (const std::uint32_t count : {1025u, 1500u, 4096u, 5000u}) {
    const PoissonTable table = make_poisson_table(count, 1);
    EXPECT_GT(table.tiles, 1u);
    EXPECT_LE(table.size, largest_poisson_tile);
    const std::uint32_t total = table.tiles * table.tiles * table.size;
    EXPECT_GE(total, count);
    EXPECT_LT(total - count, table.tiles * table.tiles);
    if (count == 1025 || (count == 4096 && !slow_build)) expect_maximal(count, 1);
  }
}

TEST(Poisson, TablesAreTheSameEveryTime) {
  const PoissonTable a = make_poisson_table(100, 3), b = make_poisson_table(100, 3), c = make_poisson_table(100, 4);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.v, b.v);
  EXPECT_NE(a.u, c.u);
}

// What a packet draws in any pixel and dimension is the table's set, shifted exactly.
TEST(Poisson, PacketsDrawMaximalSets) {
  for (const std::uint32_t count : {1u, 2u, 3u, 16u, 17u, 64u, 100u}) {
    const float distance = make_poisson_table(count, 9).distance;
    for (const Dimensions dimensions : all_dimensions) {
      const std::vector<TorusPoint> points = drawn(count, 7, 300, dimensions, 9);
      EXPECT_GE(least_distance(points), double{distance}) << count << " points";
      EXPECT_TRUE(is_covered(points, distance)) << count << " points";
    }
  }
  for (const std::uint32_t count : {1024u, 1500u}) {
    if (slow_build) break;
    const float distance = make_poisson_table(count, 9).distance;
    EXPECT_GE(least_distance(drawn(count, 2, 1, {pixel_x}, 9)), distance - 0x1p-23);
  }
}

// The check notices defects: points in jittered cells, a set without one of its points, and one with a moved point.
TEST(Poisson, OtherSetsAreToldApart) {
  const PoissonTable table = make_poisson_table(64, 0);
  const double distance = table.distance;
  const std::vector<TorusPoint> points = points_of_table(table);
  for (std::size_t i = 0; i < points.size(); i++) {
    std::vector<TorusPoint> without = points;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(is_covered(without, distance));
    std::vector<TorusPoint> moved = points;
    std::size_t nearest = i == 0 ? 1 : 0;
    for (std::size_t k = 0; k < points.size(); k++) {
      if (k != i && torus_distance(points[k], points[i]) < torus_distance(points[nearest], points[i])) nearest = k;
    }
    const TorusPoint to = points[nearest];
    moved[i] = {to.u + 0.5 * distance > 1 ? to.u - 0.5 * distance : to.u + 0.5 * distance, to.v};
    EXPECT_LT(least_distance(moved), distance);
  }
  const Points p = points_of(sampling_frame(Pattern::jittered, 64), 0, 0, {pixel_x}, 64);
  std::vector<TorusPoint> jittered;
  for (std::size_t i = 0; i < 64; i++) jittered.push_back({p.u[i], p.v[i]});
  EXPECT_LT(least_distance(jittered), distance);
  EXPECT_FALSE(is_covered(jittered, least_distance(jittered)));
}

// On a circle: no two nearer than 2/3 of 1/count, no gap wider than 4/3 of it.
TEST(Poisson, OneDimensionIsMaximalOnTheCircle) {
  for (const std::uint32_t count : {1u, 2u, 3u, 5u, 7u, 16u, 17u, 49u, 50u, 64u, 97u, 100u, 1000u}) {
    for (const std::uint32_t seed : {0u, 2u}) {
      const Frame frame = sampling_frame(Pattern::poisson, count, seed);
      for (const auto& [x, y] : {std::pair(3, 4), {0, 0}, {17, 4000}}) {
        EXPECT_TRUE(evenly_spaced(points_of(frame, x, y, time_dimension, count).u)) << count;
      }
    }
  }
}

}  // namespace
}  // namespace penumbra::test
