// Every sample point is uniform over the square: any point of any pattern in any dimension, over many seeds and pixels.
// For each pattern, all limits leave one seed in a million to chance, over all numbers that a test looks at
// (statistics.hpp).
#include <gtest/gtest.h>

#include <random>

#include "base/test_scale.hpp"
#include "sampling/randomness.hpp"

namespace penumbra::test {
namespace {

constexpr std::size_t dimension_count = std::size(all_dimensions);

class Uniformity : public testing::TestWithParam<Pattern> {
 protected:
  // The points with these indices of every pixel, each pixel with its own seed.
  static std::vector<Points> points_of_seeds(std::uint32_t count, Dimensions dimensions,
                                             const std::vector<std::size_t>& indices, int seeds) {
    Frame frame = sampling_frame(GetParam(), count, 1);
    std::vector<Points> lists(indices.size());
    const Kernel& kernel = *usable_kernels().back();
    Points some{std::vector<float>(indices.back() + 1), std::vector<float>(indices.back() + 1)};
    for (int i = 0; i < seeds; i++) {
      frame.settings.seed = static_cast<std::uint32_t>(i);
      kernel.sample_points(frame, i % 1024, i / 1024, dimensions.first, some.u, some.v);
      for (std::size_t k = 0; k < indices.size(); k++) {
        lists[k].u.push_back(some.u[indices[k]]);
        lists[k].v.push_back(some.v[indices[k]]);
      }
    }
    return lists;
  }
};

TEST_P(Uniformity, OfSinglePointsOverSeeds) {
  struct Set {
    std::uint32_t count;
    std::vector<std::size_t> indices;
    Dimensions dimensions;
    int seeds;
  };
  constexpr Dimensions padded{0x2c1b3c6du};
  constexpr int many = scaled(1 << 20, 1 << 14), some = scaled(1 << 16, 1 << 13);
  const Set sets[] = {
      {50, {0, 3}, {pixel_x}, many},      {50, {0, 3}, padded, many},         {50, {0, 49}, {pixel_x}, some},
      {50, {0, 49}, padded, some},        {50, {0, 15}, {lens_radius}, some}, {50, {0, 15}, {first_light_radius}, some},
      {50, {2, 7}, time_dimension, some}, {7, {0, 6}, {pixel_x}, some},       {7, {1, 6}, padded, some},
      {1, {0}, {pixel_x}, some},          {2, {0, 1}, padded, some},          {16, {5, 15}, {pixel_x}, some}};
  const double limit = normal_limit(2 * std::size(sets) * numbers_of_square);
  for (const Set& set : sets) {
    const auto lists = points_of_seeds(set.count, set.dimensions, set.indices, set.seeds);
    for (std::size_t k = 0; k < lists.size(); k++) {
      const double worst = set.dimensions.first == shutter_time ? unevenness(lists[k].u) : unevenness(lists[k]);
      EXPECT_LT(worst, limit) << "point " << set.indices[k] << " of " << set.count << ", dimension "
                              << set.dimensions.first;
    }
  }
}

// All points of one set together, because a picture shows their mean.
TEST_P(Uniformity, OfAllPointsOfOneSeed) {
  constexpr int size = scaled(64, 16);
  const double limit = normal_limit(dimension_count * numbers_of_square);
  const Frame frame = sampling_frame(GetParam(), 50, 4);
  for (const Dimensions dimensions : all_dimensions) {
    Points all;
    for (int pixel = 0; pixel < size * size; pixel++) {
      const Points p = points_of(frame, pixel % size, pixel / size, dimensions, 50);
      all.u.insert(all.u.end(), p.u.begin(), p.u.end());
      all.v.insert(all.v.end(), p.v.begin(), p.v.end());
    }
    // Points that are spread better than random ones only give smaller values.
    EXPECT_LT(unevenness(all), limit) << dimensions.first;
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, Uniformity,
                         testing::Values(Pattern::random, Pattern::jittered, Pattern::multijittered, Pattern::poisson,
                                         Pattern::halton, Pattern::sobol, Pattern::bluenoise),
                         [](const auto& p) { return name_of(p.param); });

// The one pattern that is not random is the same everywhere.
TEST(Regular, IgnoresPixelAndSeed) {
  for (const std::uint32_t count : {1u, 7u, 16u, 50u}) {
    const Frame frame = sampling_frame(Pattern::regular, count, 1), other = sampling_frame(Pattern::regular, count, 2);
    for (const Dimensions dimensions : all_dimensions) {
      const Points points = points_of(frame, 0, 0, dimensions, count);
      for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {17, 4000}}) {
        EXPECT_EQ(points_of(frame, x, y, dimensions, count).u, points.u);
        EXPECT_EQ(points_of(other, x, y, dimensions, count).v, points.v);
      }
    }
  }
}

// --- Defects that the checks notice, within the same limits. ---

Points truly_random(int count, unsigned seed) {
  std::mt19937 random(seed);
  Points points;
  for (int i = 0; i < count; i++) {
    points.u.push_back(static_cast<float>(random() >> 8) * 0x1p-24f);
    points.v.push_back(static_cast<float>(random() >> 8) * 0x1p-24f);
  }
  return points;
}

class UniformityChecks : public testing::Test {
 protected:
  const double limit = normal_limit(24 * numbers_of_square);
  Points points = truly_random(1 << 20, 3);
};

TEST_F(UniformityChecks, PassRandomNumbers) { EXPECT_LT(unevenness(points), limit); }

// 1 % more than average on one half of the square, 1 % less on the other.
TEST_F(UniformityChecks, NoticeOnePercentMoreOnOneSide) {
  for (float& u : points.u) u = u < 0.505f ? u / 1.01f : 0.5f + (u - 0.505f) / 0.99f;
  EXPECT_GT(unevenness(points), limit);
}

// 1 % more in two opposite quarters of the square, less in the others: each dimension by itself is uniform.
TEST_F(UniformityChecks, NoticeOnePercentMoreInOppositeQuarters) {
  for (std::size_t i = 0; i < points.u.size(); i++) {
    const float half = points.u[i] < 0.5f ? 0.505f : 0.495f;
    float& v = points.v[i];
    v = v < half ? v * 0.5f / half : 0.5f + (v - half) * 0.5f / (1 - half);
  }
  EXPECT_LT(std::max(unevenness(points.u), unevenness(points.v)), limit);
  EXPECT_GT(unevenness(points), limit);
}

TEST_F(UniformityChecks, NoticeCoarseNumbers) {
  for (float& v : points.v) v = std::floor(v * 100) / 100;
  EXPECT_GT(unevenness(points), limit);
}

TEST_F(UniformityChecks, NoticeShiftedNumbers) {
  for (float& u : points.u) u = std::min(u + 0.002f, 0.999f);
  EXPECT_GT(unevenness(points), limit);
}

TEST_F(UniformityChecks, NoticeOneDimensionTwice) {
  points.v = points.u;
  EXPECT_GT(unevenness(points), limit);
}

}  // namespace
}  // namespace penumbra::test
