// FLIP: the properties the paper states, and numbers from a second implementation of its equations that was written
// independently (two-dimensional kernels in double precision, scipy.ndimage.correlate). The tolerance is for float
// filters under the square root of the feature term.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "image/metrics.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

constexpr double tolerance = 5e-5;

double flat_flip(float ar, float ag, float ab, float br, float bg, float bb) {
  return flip(test::flat(20, 20, ar, ag, ab), test::flat(20, 20, br, bg, bb));
}

TEST(Flip, EqualPicturesGiveZero) {
  EXPECT_EQ(flip(test::pattern(40, 30), test::pattern(40, 30)), 0);
  EXPECT_EQ(flip(test::wild(20, 20), test::wild(20, 20)), 0);
}

TEST(Flip, IsSymmetric) {
  const Image a = test::pattern(40, 30), b = test::pattern(40, 30, 60);
  EXPECT_EQ(flip_map(a, b), flip_map(b, a));
}

TEST(Flip, LiesBetweenZeroAndOne) {
  for (const float v : flip_map(test::pattern(50, 40), test::pattern(50, 40, 128))) {
    EXPECT_GE(v, 0);
    EXPECT_LE(v, 1);
  }
  EXPECT_LE(flip(test::wild(20, 20), test::pattern(20, 20)), 1);
}

// Flat pictures have no features, only the colour distance of section 4.1; by hand, for black against white:
// HyAB = 100, 100^0.7 = 25.119; green against blue 41.290; 0.95 + 0.05 (25.119 - 16.516) / (41.290 - 16.516) = 0.9674.
TEST(Flip, FlatColours) {
  EXPECT_NEAR(flat_flip(0, 0, 0, 1, 1, 1), 0.967379761961, tolerance);
  EXPECT_NEAR(flat_flip(0, 1, 0, 0, 0, 1), 1, tolerance);  // the largest possible distance
  EXPECT_NEAR(flat_flip(0.5f, 0.5f, 0.5f, 0.6f, 0.5f, 0.5f), 0.249604398793, tolerance);
  EXPECT_NEAR(flat_flip(1, 0, 0, 0, 0, 0), 0.970497336767, tolerance);
  EXPECT_NEAR(flat_flip(0.2f, 0.2f, 0.2f, 0.21f, 0.21f, 0.21f), 0.063993433564, tolerance);
}

TEST(Flip, Patterns) {
  EXPECT_NEAR(flip(test::pattern(64, 48), test::pattern(64, 48, 20)), 0.297650192610, tolerance);
  EXPECT_NEAR(flip(test::pattern(64, 48), test::pattern(64, 48, 3)), 0.083032598151, tolerance);
  EXPECT_NEAR(flip(test::pattern(30, 90), test::pattern(30, 90, 100)), 0.550419109018, tolerance);
}

TEST(Flip, APointAndAnEdge) {
  const Image black = test::flat(41, 41, 0, 0, 0);
  Image point = black, edge = black;
  std::fill_n(point.rgb.begin() + 3 * (20 * 41 + 20), 3, 1.0f);
  for (std::size_t i = 0; i < edge.rgb.size(); i++) edge.rgb[i] = i / 3 % 41 >= 20 ? 0.5f : 0.0f;
  const std::vector<float> point_map = flip_map(black, point), edge_map = flip_map(black, edge);
  EXPECT_NEAR(point_map[20 * 41 + 20], 0.864906476, tolerance);
  EXPECT_NEAR(edge_map[20 * 41 + 20], 0.893447489, tolerance);
  EXPECT_NEAR(edge_map[20 * 41 + 19], 0.756998052, tolerance);
}

TEST(Flip, FromFurtherAway) {
  const std::vector<float> map = flip_map(test::pattern(64, 48), test::pattern(64, 48, 20), 20);
  double sum = 0;
  for (const float v : map) sum += v;
  EXPECT_NEAR(sum / static_cast<double>(map.size()), 0.275375861, tolerance);
}

TEST(Flip, ColoursBeyondTheScreenAreClamped) {
  EXPECT_EQ(flat_flip(1, 1, 1, 7, 1, INFINITY), 0);
  EXPECT_EQ(flat_flip(0, 0, 0, -7, NAN, 0), 0);
}

TEST(Flip, TinyPictures) {
  EXPECT_EQ(flip(test::pattern(1, 1), test::pattern(1, 1)), 0);
  EXPECT_NEAR(flip(test::flat(1, 1, 0, 0, 0), test::flat(1, 1, 1, 1, 1)), 0.967379761961, tolerance);
  EXPECT_GT(flip(test::flat(3, 1, 0, 0, 0), test::flat(3, 1, 1, 1, 1)), 0.9);
}

}  // namespace
}  // namespace penumbra
