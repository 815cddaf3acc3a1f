// Sample points are pure functions of (pixel, index, count, dimension, seed): every instruction set computes the same
// bits, and each of the arguments matters.
#include <gtest/gtest.h>

#include <bit>

#include "base/test_scale.hpp"
#include "sampling/points.hpp"

namespace penumbra::test {
namespace {

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  });
}

bool same_bits(const Points& a, const Points& b) { return same_bits(a.u, b.u) && same_bits(a.v, b.v); }

// How many values are the same at the same index of both lists.
std::size_t equal_values(const std::vector<float>& a, const std::vector<float>& b) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.size(); i++) equal += a[i] == b[i] ? 1 : 0;
  return equal;
}

class Purity : public testing::TestWithParam<Pattern> {};

TEST_P(Purity, SameBitsForEveryInstructionSet) {
  for (const std::uint32_t count : {1u, 2u, 3u, 5u, 7u, 16u, 17u, 50u, 97u, 100u, 1000u, 3000u}) {
    const Frame frame = sampling_frame(GetParam(), count, 9);
    // For patterns that need the count, later passes too.
    const std::size_t length = needs_count(GetParam()) ? std::size_t{count} + 37 : count;
    for (const auto& [x, y] : {std::pair(0, 0), {40, 50}, {8191, 4095}}) {
      for (std::size_t d = 0; d <= std::size(all_dimensions); d++) {
        const Dimensions dimensions = d < std::size(all_dimensions) ? all_dimensions[d] : time_dimension;
        const Points first = points_of(frame, x, y, dimensions, length, *usable_kernels().front());
        for (const Kernel* kernel : usable_kernels()) {
          EXPECT_TRUE(same_bits(points_of(frame, x, y, dimensions, length, *kernel), first))
              << kernel->isa << ", " << count << " points, dimension " << dimensions.first;
        }
      }
    }
  }
}

// Requesting fewer points, so that packets end elsewhere, or requesting them again changes nothing.
TEST_P(Purity, PointsDoNotDependOnHowManyAreWanted) {
  const Frame frame = sampling_frame(GetParam(), 300, 9);
  for (const Dimensions dimensions : all_dimensions) {
    const Points all = points_of(frame, 40, 50, dimensions, 300);
    for (const std::size_t count : {1, 3, 16, 31, 100, 300}) {
      EXPECT_TRUE(same_bits(points_of(frame, 40, 50, dimensions, count), part_of(all, 0, count))) << count;
    }
  }
}

TEST_P(Purity, SeedPixelAndDimensionMatter) {
  if (GetParam() == Pattern::regular) GTEST_SKIP() << "regular points are the same everywhere, as tested elsewhere";
  constexpr std::size_t count = 64, few = 3;
  const Frame frame = sampling_frame(GetParam(), count, 1), other = sampling_frame(GetParam(), count, 2);
  for (const Dimensions dimensions : all_dimensions) {
    const Points points = points_of(frame, 4, 5, dimensions, count);
    EXPECT_LE(equal_values(points.u, points.v), few);
    for (const Points& p : {points_of(other, 4, 5, dimensions, count), points_of(frame, 5, 4, dimensions, count),
                            points_of(frame, 4, 6, dimensions, count), points_of(frame, 5, 5, dimensions, count)}) {
      EXPECT_LE(equal_values(points.u, p.u), few) << dimensions.first;
      EXPECT_LE(equal_values(points.v, p.v), few) << dimensions.first;
    }
    for (const Dimensions unlike : all_dimensions) {
      if (unlike.first == dimensions.first) continue;
      const Points p = points_of(frame, 4, 5, unlike, count);
      EXPECT_LE(equal_values(points.u, p.u), few) << dimensions.first << " " << unlike.first;
      EXPECT_LE(equal_values(points.v, p.v), few) << dimensions.first << " " << unlike.first;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, Purity, testing::ValuesIn(all_patterns),
                         [](const auto& p) { return name_of(p.param); });

TEST(PurityChecks, NoticeOneBit) {
  const Points points{{0.25f, 0.5f, 0}, {0.125f, 0.75f, 0}};
  Points other = points;
  EXPECT_TRUE(same_bits(points, other));
  other.v[1] = 0.75000006f;
  EXPECT_FALSE(same_bits(points, other));
  EXPECT_EQ(equal_values(points.v, other.v), 2u);
  other = points;
  other.u[2] = -0.0f;
  EXPECT_FALSE(same_bits(points, other));
  other = points;
  other.u.pop_back();
  EXPECT_FALSE(same_bits(points, other));
}

}  // namespace
}  // namespace penumbra::test
