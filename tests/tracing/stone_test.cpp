// Stone: its cells against a wider search written out plainly, its mortar, and its colours against the published ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/hash.hpp"
#include "base/test_scale.hpp"
#include "tracing/texture_points.hpp"

namespace penumbra::test {
namespace {

constexpr double cubes_per_unit = 3.1, half_width = 0.0115;

// In units.
std::vector<float> stone_borders(const Points& points) {
  std::vector<float> list = values(LaneFunction::stone_border, points);
  for (float& v : list) v /= static_cast<float>(cubes_per_unit);
  return list;
}

struct Feature {
  Vec3 way;  // from the place to the feature point, in cubes
  std::uint32_t bits;
  int cubes_away;  // of its cube, in the largest coordinate
};

// Calls visit with the feature point of every cube up to `reach` cubes away.
template <typename Visit>
void for_features(Vec3 place, int reach, Visit visit) {
  const auto mix = [](std::uint32_t before, int cube) {
    return mix_bits(static_cast<std::uint32_t>(cube) * 0x9e3779b9u + before);
  };
  const auto cube_of = [](double x) { return static_cast<int>(std::floor(x)); };
  const int x = cube_of(place.x), y = cube_of(place.y), z = cube_of(place.z);
  for (int i = -reach; i <= reach; i++) {
    for (int j = -reach; j <= reach; j++) {
      for (int k = -reach; k <= reach; k++) {
        const std::uint32_t bits = mix(mix(mix(0, x + i), y + j), z + k);
        const auto part = [bits](int shift) { return ((bits >> shift & 1023) + 0.5) / 1024; };
        const Vec3 point{x + i + part(0), y + j + part(10), z + k + part(20)};
        visit(Feature{point - place, bits, std::max({std::abs(i), std::abs(j), std::abs(k)})});
      }
    }
  }
}

struct TwinCell {
  double border = 1e9;  // in units
  Vec3 tint;
  int cubes_away = 0;  // of the own feature point
};

// The stone round a place from all feature points of 7 x 7 x 7 cubes, in double precision.
TwinCell twin_cell(Vec3 p) {
  // The packets scale the point in single precision.
  const auto to_cubes = [](double x) { return double{static_cast<float>(x) * 3.1f}; };
  std::vector<Feature> features;
  for_features({to_cubes(p.x), to_cubes(p.y), to_cubes(p.z)}, 3, [&](const Feature& f) { features.push_back(f); });
  const auto nearer = [](const Feature& a, const Feature& b) { return dot(a.way, a.way) < dot(b.way, b.way); };
  std::iter_swap(features.begin(), std::min_element(features.begin(), features.end(), nearer));
  const Feature& own = features[0];
  TwinCell cell;
  for (std::size_t i = 1; i < features.size(); i++) {
    const Vec3 middle = (features[i].way + own.way) / 2;
    cell.border = std::min(cell.border, dot(middle, normalize(features[i].way - own.way)) / cubes_per_unit);
  }
  cell.cubes_away = own.cubes_away;
  const std::uint32_t bits = mix_bits(own.bits);
  const auto share = [bits](int shift) { return (bits >> shift & 1023) / 1023.0; };
  cell.tint = {share(20) < 0.04  ? 0.61
               : share(20) < 0.1 ? 0.76
                                 : 0.82,
               0.30 + 0.10 * share(0), 0.06 + 0.21 * share(10)};
  return cell;
}

// How much nearer a place is to a feature point two cubes away than to any in the cubes between.
double loneliness(Vec3 cubes) {
  double inner = 1e9, outer = 1e9;
  for_features(cubes, 2, [&](const Feature& f) {
    double& square = f.cubes_away == 2 ? outer : inner;
    square = std::min(square, dot(f.way, f.way));
  });
  return std::sqrt(inner) - std::sqrt(outer);
}

// Places that belong to a point two cubes away are one in a million: they are found by climbing.
void add_lonely_places(Points& points) {
  std::mt19937 random(6);
  std::normal_distribution<double> step(0, 0.06);
  std::uniform_real_distribution<double> anywhere(-60, 60);
  for (int start = 0; start < scaled(3000, 0); start++) {
    const double x = anywhere(random), y = anywhere(random);
    Vec3 place{x, y, anywhere(random)};
    double highest = loneliness(place);
    for (int k = 0; k < 60; k++) {
      const double dx = step(random), dy = step(random);
      const Vec3 next = place + Vec3{dx, dy, step(random)};
      const double height = loneliness(next);
      if (height <= highest) continue;
      highest = height;
      place = next;
      if (height > 0) points.add(place.x / cubes_per_unit, place.y / cubes_per_unit, place.z / cubes_per_unit);
    }
  }
}

TEST(Texture, StoneAgreesWithAWiderSearch) {
  Points points = random_points(scaled(20000, 1000), 20);
  add_lonely_places(points);
  // Near corners, edges and faces of the cubes, on both sides of zero.
  std::mt19937 random(3);
  std::uniform_int_distribution<int> whole(-30, 30), grid(-4, 4);
  for (int i = 0; i < scaled(4000, 400); i++) {
    const auto place = [&] { return (whole(random) + grid(random) * 1e-4) / cubes_per_unit; };
    const double x = place(), y = place();
    points.add(x, y, place());
  }
  const std::vector<float> border = stone_borders(points);
  std::vector<float> channel[3];
  for (int c = 0; c < 3; c++) channel[c] = values(stone_channels[c], points);
  int two_cubes_away = 0, mortar = 0;
  for (std::size_t i = 0; i < points.size(); i++) {
    const TwinCell twin = twin_cell(points.at(i));
    ASSERT_NEAR(border[i], std::min(twin.border, half_width), 2e-6) << "point " << i;
    two_cubes_away += twin.cubes_away == 2;
    EXPECT_LT(twin.cubes_away, 3);
    if (std::abs(twin.border - half_width) < 2e-6) continue;
    // The noise is the same in all channels, and smaller than from mortar to stone.
    const double red_green = channel[0][i] - channel[1][i], green_blue = channel[1][i] - channel[2][i];
    const bool stone = twin.border > half_width;
    EXPECT_NEAR(red_green, stone ? twin.tint.x - twin.tint.y : 0, 1e-6);
    EXPECT_NEAR(green_blue, stone ? twin.tint.y - twin.tint.z : 0, 1e-6);
    EXPECT_NEAR(channel[1][i], stone ? twin.tint.y : 0.6, stone ? 0.055 : 0.11);
    mortar += !stone;
  }
  if (!slow_build) {
    EXPECT_GT(two_cubes_away, 0) << "the hard case is not among the points";
  }
  EXPECT_GT(mortar, 0);
}

// Across the mortar the distance to the border grows as distance does: 1 for 1. So the mortar is a slab of even width,
// but for the corners where borders meet. (The difference of the two distances grows by anything from 0 to 2.)
TEST(Texture, MortarIsOfEvenWidth) {
  const Points candidates = random_points(scaled(60000, 6000), 20);
  const std::vector<float> border = stone_borders(candidates);
  constexpr double h = 1.0 / 1024;
  Points around;
  for (std::size_t i = 0; i < candidates.size(); i++) {
    if (border[i] < 2 * h || border[i] > half_width - 2 * h) continue;
    const Vec3 p = candidates.at(i);
    for (const double s : {-h, h}) around.add(p.x + s, p.y, p.z);
    for (const double s : {-h, h}) around.add(p.x, p.y + s, p.z);
    for (const double s : {-h, h}) around.add(p.x, p.y, p.z + s);
  }
  const std::vector<float> near = stone_borders(around);
  int even = 0, corners = 0;
  for (std::size_t i = 0; i < near.size(); i += 6) {
    const Vec3 slope = Vec3{near[i + 1] - near[i], near[i + 3] - near[i + 2], near[i + 5] - near[i + 4]} / (2 * h);
    EXPECT_LT(max_component(abs(slope)), 1.001);
    (std::abs(length(slope) - 1) < 0.01 ? even : corners)++;
  }
  EXPECT_GT(even, 100);
  EXPECT_GT(even, 9 * corners);
}

// Published: 19 % of the area of a ball is mortar, of grey 0.60 with a deviation of 0.03; most stones have a red of
// 0.82, few of 0.61. The share of a surface is that of space.
TEST(Texture, StoneHasThePublishedColours) {
  const Points points = random_points(scaled(100000, 10000), 100);
  std::vector<float> channel[3], mortar, red;
  for (int c = 0; c < 3; c++) channel[c] = values(stone_channels[c], points);
  for (std::size_t i = 0; i < points.size(); i++) {
    const bool grey = std::abs(channel[0][i] - channel[2][i]) < 0.01f;
    (grey ? mortar : red).push_back(channel[0][i]);
    if (grey) continue;
    EXPECT_GT(channel[0][i], 0.55f);
    EXPECT_LT(channel[0][i], 0.88f);
    EXPECT_GT(channel[1][i], 0.24f);
    EXPECT_LT(channel[1][i], 0.46f);
    EXPECT_GT(channel[2][i], 0.0f);
    EXPECT_LT(channel[2][i], 0.33f);
  }
  const double share = static_cast<double>(mortar.size()) / static_cast<double>(points.size());
  EXPECT_NEAR(share, 0.19, 0.015 + share_tolerance(0.19, points.size()));
  const Moments grey = moments(mortar);
  EXPECT_NEAR(grey.mean, 0.60, 0.005);
  EXPECT_NEAR(grey.deviation, 0.028, 0.004);
  std::sort(red.begin(), red.end());
  EXPECT_NEAR(red[red.size() / 2], 0.82, 0.01);
}

}  // namespace
}  // namespace penumbra::test
