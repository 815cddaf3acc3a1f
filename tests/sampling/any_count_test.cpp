// Any number of rays is allowed: the points of every pattern are in the unit square; patterns that depend on the count
// continue pass after pass; in all others, more points extend fewer ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/test_scale.hpp"
#include "sampling/points.hpp"

namespace penumbra::test {
namespace {

bool in_unit_interval(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float x) { return x >= 0 && x < 1; });
}

bool in_unit_square(const Points& points) { return in_unit_interval(points.u) && in_unit_interval(points.v); }

bool begins_with(const Points& all, const Points& fewer) {
  return fewer.u.size() <= all.u.size() && std::equal(fewer.u.begin(), fewer.u.end(), all.u.begin()) &&
         std::equal(fewer.v.begin(), fewer.v.end(), all.v.begin());
}

// Whether no point of one list equals the point at the same index of the other.
bool differ_everywhere(const Points& a, const Points& b) {
  for (std::size_t i = 0; i < a.u.size(); i++) {
    if (a.u[i] == b.u[i] && a.v[i] == b.v[i]) return false;
  }
  return true;
}

std::vector<std::uint32_t> many_counts() {
  std::vector<std::uint32_t> counts;
  for (std::uint32_t count = 1; count <= 64; count++) counts.push_back(count);
  for (const std::uint32_t count : {100u, 1000u, 5000u}) counts.push_back(count);
  return counts;
}

class AnyCount : public testing::TestWithParam<Pattern> {};

TEST_P(AnyCount, PointsAreInTheUnitSquare) {
  for (const std::uint32_t count : many_counts()) {
    const Frame frame = sampling_frame(GetParam(), count, 2);
    for (const auto& [x, y] : {std::pair(0, 0), {1919, 1079}}) {
      for (const Dimensions dimensions : all_dimensions) {
        EXPECT_TRUE(in_unit_square(points_of(frame, x, y, dimensions, count))) << count << " " << dimensions.first;
      }
      EXPECT_TRUE(in_unit_square(points_of(frame, x, y, time_dimension, count))) << count;
    }
  }
}

// All points of a large set are different: nothing is drawn twice.
TEST_P(AnyCount, PointsOfASetDiffer) {
  for (const std::uint32_t count : {2u, 7u, 50u, 1000u}) {
    const Frame frame = sampling_frame(GetParam(), count, 3);
    for (const Dimensions dimensions : all_dimensions) {
      const Points points = points_of(frame, 4, 5, dimensions, count);
      std::vector<std::pair<float, float>> places;
      for (std::size_t i = 0; i < count; i++) places.emplace_back(points.u[i], points.v[i]);
      std::sort(places.begin(), places.end());
      EXPECT_TRUE(std::adjacent_find(places.begin(), places.end()) == places.end()) << count << " " << dimensions.first;
    }
  }
}

TEST_P(AnyCount, PassesFollowPassesOrPointsGoOn) {
  for (const std::uint32_t count : {1u, 7u, 16u, 50u}) {
    const Frame frame = sampling_frame(GetParam(), count, 3);
    if (needs_count(GetParam())) {
      for (const Dimensions dimensions : all_dimensions) {
        const Points all = points_of(frame, 4, 5, dimensions, 3 * count);
        EXPECT_TRUE(in_unit_square(all));
        for (std::size_t pass = 1; pass < 3; pass++) {
          const Points first = part_of(all, 0, count), later = part_of(all, pass * count, (pass + 1) * count);
          if (GetParam() == Pattern::regular) {
            EXPECT_TRUE(first.u == later.u && first.v == later.v) << count;
          } else {
            EXPECT_TRUE(differ_everywhere(first, later)) << count << " " << dimensions.first;
          }
        }
      }
    } else {
      const Frame larger = sampling_frame(GetParam(), 1025, 3);
      for (const Dimensions dimensions : all_dimensions) {
        EXPECT_TRUE(begins_with(points_of(larger, 4, 5, dimensions, 1025), points_of(frame, 4, 5, dimensions, count)))
            << count << " " << dimensions.first;
      }
      EXPECT_TRUE(
          begins_with(points_of(larger, 4, 5, time_dimension, 1025), points_of(frame, 4, 5, time_dimension, count)));
    }
  }
}

// For a pattern that needs the count, another count gives other points.
TEST_P(AnyCount, OnlySequencesIgnoreTheCount) {
  for (const Dimensions dimensions : all_dimensions) {
    const Points all = points_of(sampling_frame(GetParam(), 64, 3), 4, 5, dimensions, 64);
    const Points fewer = points_of(sampling_frame(GetParam(), 50, 3), 4, 5, dimensions, 50);
    EXPECT_EQ(begins_with(all, fewer), !needs_count(GetParam())) << dimensions.first;
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, AnyCount, testing::ValuesIn(all_patterns),
                         [](const auto& p) { return name_of(p.param); });

// Beyond the table of joint dimensions the sequence continues with different points.
TEST(Sobol, PointsBeyondTheTableAreOthers) {
  constexpr std::uint32_t count = largest_sobol_table + 4096;
  const Frame frame = sampling_frame(Pattern::sobol, count, 3);
  for (const Dimensions dimensions : all_dimensions) {
    const Points all = points_of(frame, 1, 2, dimensions, count);
    EXPECT_TRUE(in_unit_square(all));
    EXPECT_TRUE(differ_everywhere(part_of(all, largest_sobol_table, count), part_of(all, 0, 4096)));
  }
}

TEST(AnyCountChecks, NoticeWhatIsOutside) {
  EXPECT_TRUE(in_unit_square({{0}, {0.99999994f}}));
  EXPECT_FALSE(in_unit_square({{1}, {0}}));
  EXPECT_FALSE(in_unit_square({{0}, {1}}));
  EXPECT_FALSE(in_unit_square({{-1e-9f}, {0}}));
  EXPECT_FALSE(in_unit_square({{std::nanf("")}, {0}}));
}

TEST(AnyCountChecks, NoticeOtherPoints) {
  const Points all{{0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}};
  EXPECT_TRUE(begins_with(all, {{0.1f, 0.2f}, {0.4f, 0.5f}}));
  EXPECT_FALSE(begins_with(all, {{0.1f, 0.2f}, {0.4f, 0.51f}}));
  EXPECT_FALSE(begins_with(all, {{0.2f, 0.1f}, {0.5f, 0.4f}}));
  EXPECT_FALSE(differ_everywhere(all, {{0.3f, 0.2f, 0.1f}, {0.4f, 0.5f, 0.6f}}));
}

}  // namespace
}  // namespace penumbra::test
