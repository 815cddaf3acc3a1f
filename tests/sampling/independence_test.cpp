// Dimensions, pixels and seeds are independent of each other. For each pattern, all limits leave one seed in a million
// to chance, over all numbers that a test looks at (statistics.hpp).
#include <gtest/gtest.h>

#include <random>

#include "base/test_scale.hpp"
#include "sampling/randomness.hpp"

namespace penumbra::test {
namespace {

// One dimension of a set of points.
struct Column {
  Dimensions of;
  std::vector<float> values;
};

// All dimensions of the first `count` points of a pixel, time included.
std::vector<Column> columns_of(const Frame& frame, int x, int y, std::size_t count) {
  std::vector<Column> columns;
  for (const Dimensions dimensions : all_dimensions) {
    Points p = points_of(frame, x, y, dimensions, count);
    columns.push_back({dimensions, std::move(p.u)});
    columns.push_back({dimensions, std::move(p.v)});
  }
  columns.push_back({time_dimension, points_of(frame, x, y, time_dimension, count).u});
  return columns;
}

// Patterns that differ from pixel to pixel.
const auto random_patterns = testing::Values(Pattern::random, Pattern::jittered, Pattern::multijittered,
                                             Pattern::poisson, Pattern::halton, Pattern::sobol, Pattern::bluenoise);
const auto name_of_test = [](const auto& p) { return name_of(p.param); };

// One point from each of many pixels, as in a picture with one ray per pixel: plain random numbers.
class AcrossPixels : public testing::TestWithParam<Pattern> {
 protected:
  static constexpr int size = scaled(128, 64);

  // Point `index` of every pixel.
  static std::vector<Column> columns(const Frame& frame, std::size_t index) {
    std::vector<Column> result;
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        const std::vector<Column> here = columns_of(frame, x, y, index + 1);
        result.resize(here.size());
        for (std::size_t i = 0; i < here.size(); i++) {
          result[i].of = here[i].of;
          result[i].values.push_back(here[i].values[index]);
        }
      }
    }
    return result;
  }
};

TEST_P(AcrossPixels, NeighboursAreIndependent) {
  if (GetParam() == Pattern::bluenoise) GTEST_SKIP() << "neighbours differ on purpose";
  const std::vector<Column> all = columns(sampling_frame(GetParam(), 16, 6), 3);
  const double limit = normal_limit(4 * static_cast<double>(all.size()) * numbers_of_dependence);
  for (const Column& column : all) {
    for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}, {2, 0}}) {
      EXPECT_LT(neighbour_dependence(column.values, size, dx, dy), limit) << column.of.first << " " << dx << " " << dy;
    }
  }
}

TEST_P(AcrossPixels, DimensionsAreIndependent) {
  const std::vector<Column> all = columns(sampling_frame(GetParam(), 16, 7), 2);
  const auto pairs = static_cast<double>(all.size() * (all.size() - 1)) / 2;
  const double limit = normal_limit(pairs * numbers_of_dependence);
  for (std::size_t a = 0; a < all.size(); a++) {
    for (std::size_t b = 0; b < a; b++) {
      EXPECT_LT(dependence(all[a].values, all[b].values), limit) << all[a].of.first << " " << all[b].of.first;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, AcrossPixels, random_patterns, name_of_test);

// Within a pixel, numbers of different dimensions pair up at random. The squared correlation of n pairs that are paired
// at random is 1 / (n - 1) on average; over P pixels its relative error is sqrt(2 / P). Sequences pair up whole blocks,
// in which consecutive points are on opposite sides in both dimensions: that gives up to twice as much, never more.
// Dimensions that are not shuffled against each other show here: they would be in the same order, or their first bits
// would be the same bit of the index, and the mean far larger.
class WithinPixels : public testing::TestWithParam<Pattern> {
 protected:
  // Two dimensions that are stratified together on purpose.
  static bool belong_together(const Column& a, const Column& b) {
    if (a.of.first == b.of.first) return true;
    switch (GetParam()) {
      case Pattern::sobol:
      case Pattern::bluenoise:
        return a.of.joint() && b.of.joint();
      case Pattern::halton:
        return std::max(a.of.first, b.of.first) == shutter_time && std::min(a.of.first, b.of.first) == pixel_x;
      default:
        return false;
    }
  }
};

TEST_P(WithinPixels, DimensionsPairUpAtRandom) {
  const int pixels = scaled(1024, 256);
  for (const std::size_t count : {std::size_t{16}, std::size_t{50}, std::size_t{64}, std::size_t{256}}) {
    const Frame frame = sampling_frame(GetParam(), static_cast<std::uint32_t>(count), 8);
    std::vector<Column> columns;
    std::vector<double> squares;
    for (int pixel = 0; pixel < pixels; pixel++) {
      columns = columns_of(frame, pixel % 32, pixel / 32, count);
      squares.resize(columns.size() * columns.size());
      for (std::size_t a = 0; a < columns.size(); a++) {
        for (std::size_t b = 0; b < a; b++) {
          if (belong_together(columns[a], columns[b])) continue;
          const double r = correlation(columns[a].values, columns[b].values);
          squares[a * columns.size() + b] += r * r;
        }
      }
    }
    const auto pairs = static_cast<double>(columns.size() * (columns.size() - 1)) / 2;
    const double limit = normal_limit(4 * 2 * pairs) * std::sqrt(2.0 / pixels);
    const double most = needs_count(GetParam()) || GetParam() == Pattern::random ? 1 : 2;
    for (std::size_t a = 0; a < columns.size(); a++) {
      for (std::size_t b = 0; b < a; b++) {
        if (belong_together(columns[a], columns[b])) continue;
        const double mean = squares[a * columns.size() + b] / pixels * (static_cast<double>(count) - 1);
        EXPECT_GT(mean, 1 - limit) << columns[a].of.first << " " << columns[b].of.first << ", " << count << " points";
        EXPECT_LT(mean, most + limit) << columns[a].of.first << " " << columns[b].of.first << ", " << count
                                      << " points";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, WithinPixels, random_patterns, name_of_test);

// The fixed pattern has a fixed order in each dimension, but no two are the same.
TEST(Regular, OrdersOfDimensionsAreUnlike) {
  for (const std::size_t count : {std::size_t{50}, std::size_t{64}, std::size_t{256}, std::size_t{1000}}) {
    const std::vector<Column> columns = columns_of(sampling_frame(Pattern::regular, count, 1), 0, 0, count);
    const double limit = normal_limit(2 * 4 * static_cast<double>(columns.size() * (columns.size() - 1)) / 2);
    for (std::size_t a = 0; a < columns.size(); a++) {
      for (std::size_t b = 0; b < a; b++) {
        if (columns[a].of.first == columns[b].of.first) continue;
        EXPECT_LT(std::abs(correlation(columns[a].values, columns[b].values)) * std::sqrt(count - 1.0), limit)
            << columns[a].of.first << " " << columns[b].of.first << ", " << count << " points";
      }
    }
  }
}

// --- Defects that the checks notice. ---

class IndependenceChecks : public testing::Test {
 protected:
  static constexpr int size = 128;
  const double limit = normal_limit(105 * numbers_of_dependence);

  static std::vector<float> noise(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<float> values;
    for (int i = 0; i < size * size; i++) values.push_back(static_cast<float>(random() >> 8) * 0x1p-24f);
    return values;
  }
};

TEST_F(IndependenceChecks, PassRandomNumbers) {
  EXPECT_LT(dependence(noise(1), noise(2)), limit);
  EXPECT_LT(neighbour_dependence(noise(1), size, 1, 0), limit);
}

TEST_F(IndependenceChecks, NoticeEqualDimensions) { EXPECT_GT(dependence(noise(1), noise(1)), limit); }

// A number and its copy shifted by 0.21 on the circle are hardly correlated, and yet one determines the other.
TEST_F(IndependenceChecks, NoticeShiftedDimensions) {
  std::vector<float> shifted = noise(1);
  for (float& x : shifted) x = x < 0.79f ? x + 0.21f : x - 0.79f;
  EXPECT_GT(dependence(noise(1), shifted), limit);
}

// Every eighth number is the same.
TEST_F(IndependenceChecks, NoticeWhatIsPartlyEqual) {
  const std::vector<float> a = noise(1);
  std::vector<float> b = noise(2);
  for (std::size_t i = 0; i < a.size(); i += 8) b[i] = a[i];
  EXPECT_GT(dependence(a, b), limit);
}

TEST_F(IndependenceChecks, NoticeEqualNeighbours) {
  std::vector<float> values = noise(3);
  for (std::size_t i = 0; i + 1 < values.size(); i += 8) values[i + 1] = values[i];
  EXPECT_GT(neighbour_dependence(values, size, 1, 0), limit);
  EXPECT_LT(neighbour_dependence(values, size, 0, 1), limit);
}

TEST_F(IndependenceChecks, NoticeEqualRows) {
  std::vector<float> values = noise(3);
  for (int y = 0; y + 1 < size; y += 4) std::copy_n(values.begin() + y * size, size, values.begin() + (y + 1) * size);
  EXPECT_GT(neighbour_dependence(values, size, 0, 1), limit);
}

// The same permutation for two stratified dimensions.
TEST_F(IndependenceChecks, NoticeTheSameOrderTwice) {
  const Frame frame = sampling_frame(Pattern::jittered, 50, 1);
  double same = 0, different = 0;
  for (int pixel = 0; pixel < 256; pixel++) {
    const std::vector<float> a = points_of(frame, pixel, 0, {pixel_x}, 50).v;
    std::vector<float> b = points_of(frame, pixel, 1, {pixel_x}, 50).v, ordered(50);
    different += std::pow(correlation(a, b), 2) * 49 / 256;
    std::sort(b.begin(), b.end());
    for (std::size_t i = 0; i < 50; i++) {
      ordered[i] = b[static_cast<std::size_t>(std::count_if(a.begin(), a.end(), [&](float x) { return x < a[i]; }))];
    }
    same += std::pow(correlation(a, ordered), 2) * 49 / 256;
  }
  const double allowance = normal_limit(8 * 105) * std::sqrt(2.0 / 256);
  EXPECT_NEAR(different, 1, allowance);
  EXPECT_GT(same, 1 + allowance);
}

}  // namespace
}  // namespace penumbra::test
