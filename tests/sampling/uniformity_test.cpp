// Sample points are uniform, and nothing ties one dimension or pixel to another. All limits leave one seed in a million
// to chance, over all numbers that a test looks at (statistics.hpp).
#include <gtest/gtest.h>

#include <cmath>

#include "base/test_scale.hpp"
#include "sampling/points.hpp"
#include "sampling/statistics.hpp"

namespace penumbra::test {
namespace {

constexpr std::size_t dimension_count = std::size(all_dimensions);

// 16 x 16 cells.
std::vector<int> cell_counts(const std::vector<float>& u, const std::vector<float>& v) {
  std::vector<int> counts(256);
  for (std::size_t i = 0; i < u.size(); i++) {
    counts[static_cast<std::size_t>(u[i] * 16) * 16 + static_cast<std::size_t>(v[i] * 16)]++;
  }
  return counts;
}

double mean_of(const std::vector<float>& a) {
  double sum = 0;
  for (const float v : a) sum += v;
  return sum / static_cast<double>(a.size());
}

TEST(Random, IsUniformInEveryPixel) {
  const std::size_t count = scaled(16384, 4096);
  const Frame frame = sampling_frame(Pattern::random, 16, 4);
  const double limit = normal_limit(3 * 16 * dimension_count);
  for (int pixel = 0; pixel < 16; pixel++) {
    for (const Dimensions dimensions : all_dimensions) {
      const Points points = points_of(frame, pixel % 4, pixel / 4, dimensions, count);
      EXPECT_LT(chi_square_deviation(cell_counts(points.u, points.v)), limit);
      const double error = limit / std::sqrt(12.0 * static_cast<double>(count));
      EXPECT_NEAR(mean_of(points.u), 0.5, error);
      EXPECT_NEAR(mean_of(points.v), 0.5, error);
    }
  }
}

// One sample each of many pixels, as in a picture with one ray a pixel: both patterns are plain random there.
class AcrossPixels : public testing::TestWithParam<Pattern> {
 protected:
  static constexpr int size = scaled(128, 64);

  // Point `index` of every pixel.
  static Points points(const Frame& frame, Dimensions dimensions, std::size_t index) {
    Points result;
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        const Points p = points_of(frame, x, y, dimensions, index + 1);
        result.u.push_back(p.u[index]);
        result.v.push_back(p.v[index]);
      }
    }
    return result;
  }
};

TEST_P(AcrossPixels, IsUniform) {
  const Frame frame = sampling_frame(GetParam(), 16, 5);
  const double limit = normal_limit(2 * dimension_count);
  for (const Dimensions dimensions : all_dimensions) {
    for (const std::size_t index : {std::size_t{0}, std::size_t{5}}) {
      const Points p = points(frame, dimensions, index);
      EXPECT_LT(chi_square_deviation(cell_counts(p.u, p.v)), limit) << dimensions.first << " " << index;
    }
  }
}

TEST_P(AcrossPixels, NeighboursAreNotCorrelated) {
  const Frame frame = sampling_frame(GetParam(), 16, 6);
  const double limit = normal_limit(2 * 4 * dimension_count) / (size - 1);
  for (const Dimensions dimensions : all_dimensions) {
    const Points p = points(frame, dimensions, 3);
    for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}, {2, 0}}) {
      std::vector<float> here, there;
      for (int y = 0; y + dy < size; y++) {
        for (int x = 0; x + dx < size; x++) {
          here.push_back(p.u[static_cast<std::size_t>(y * size + x)]);
          there.push_back(p.u[static_cast<std::size_t>((y + dy) * size + x + dx)]);
        }
      }
      EXPECT_LT(std::abs(correlation(here, there)), limit * 1.02) << dimensions.first << " " << dx << " " << dy;
    }
  }
}

TEST_P(AcrossPixels, DimensionsAreNotCorrelated) {
  const Frame frame = sampling_frame(GetParam(), 16, 7);
  std::vector<std::vector<float>> columns;
  for (const Dimensions dimensions : all_dimensions) {
    Points p = points(frame, dimensions, 2);
    columns.push_back(std::move(p.u));
    columns.push_back(std::move(p.v));
  }
  const double limit = normal_limit(2 * columns.size() * columns.size() / 2.0);
  for (std::size_t a = 0; a < columns.size(); a++) {
    for (std::size_t b = 0; b < a; b++) {
      if (columns[a] == columns[b]) continue;  // the same joint dimension, named twice
      EXPECT_LT(std::abs(correlation(columns[a], columns[b])) * size, limit) << a << " " << b;
      EXPECT_LT(chi_square_deviation(cell_counts(columns[a], columns[b])), limit) << a << " " << b;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, AcrossPixels, testing::Values(Pattern::random, Pattern::sobol),
                         [](const auto& p) { return std::string(pattern_names[static_cast<int>(p.param)]); });

// Within a pixel: numbers of different padded dimensions, or of a padded and a joint one, pair up at random. The
// squared correlation of n pairs that are paired at random is 1 / (n - 1) in the mean; over P pixels its relative error
// is sqrt(2 / P). The default pattern pairs up whole blocks, in which a point and the next are on opposite sides in
// both dimensions: that gives up to twice as much, never more. Numbers that are not shuffled against each other show
// here: their first bits would be the same bit of the index, and the mean far above.
TEST(Padding, DimensionsPairUpAtRandom) {
  for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
    for (const std::size_t count : {std::size_t{16}, std::size_t{64}, std::size_t{256}}) {
      const Frame frame = sampling_frame(pattern, static_cast<std::uint32_t>(count), 8);
      const int pixels = scaled(1024, 256);
      constexpr std::size_t columns = 2 * dimension_count;
      std::vector<double> squares(columns * columns);
      for (int pixel = 0; pixel < pixels; pixel++) {
        std::vector<std::vector<float>> values;
        for (const Dimensions dimensions : all_dimensions) {
          Points p = points_of(frame, pixel % 32, pixel / 32, dimensions, count);
          values.push_back(std::move(p.u));
          values.push_back(std::move(p.v));
        }
        for (std::size_t a = 0; a < columns; a++) {
          for (std::size_t b = 0; b < a; b++) {
            const double r = correlation(values[a], values[b]);
            squares[a * columns + b] += r * r;
          }
        }
      }
      const double limit = normal_limit(6 * columns * columns / 2.0) * std::sqrt(2.0 / pixels);
      for (std::size_t a = 0; a < columns; a++) {
        for (std::size_t b = 0; b < a; b++) {
          const Dimensions da = all_dimensions[a / 2], db = all_dimensions[b / 2];
          // Two joint dimensions, and the two of a padded pair, are stratified together on purpose.
          if (a / 2 == b / 2 || (da.joint() && db.joint())) continue;
          const double mean = squares[a * columns + b] / pixels * (static_cast<double>(count) - 1);
          const double most = pattern == Pattern::random ? 1 : 2;
          EXPECT_GT(mean, 1 - limit) << da.first << " " << db.first << ", " << count << " points";
          EXPECT_LT(mean, most + limit) << da.first << " " << db.first << ", " << count << " points";
        }
      }
    }
  }
}

}  // namespace
}  // namespace penumbra::test
