// Marble: its greys against the published ones, and that it is continuous.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/test_scale.hpp"
#include "tracing/texture_points.hpp"

namespace penumbra::test {
namespace {

// Published: grey from 0 to 0.70 with a median of 0.38 and, over the whole ball, a mean of 0.38 and a deviation of
// 0.18.
TEST(Texture, MarbleHasThePublishedGreys) {
  std::vector<float> grey = values(LaneFunction::marble, random_points(scaled(100000, 10000), 100));
  std::sort(grey.begin(), grey.end());
  EXPECT_GE(grey.front(), -1e-6f);
  EXPECT_LT(grey.front(), 0.01f);
  EXPECT_LE(grey.back(), 0.711f);
  EXPECT_GT(grey.back(), 0.70f);
  EXPECT_NEAR(grey[grey.size() / 2], 0.38, 0.03);
  const Moments m = moments(grey);
  EXPECT_NEAR(m.mean, 0.38, 0.03);
  EXPECT_NEAR(m.deviation, 0.18, 0.02);
}

// Creases are sharp, but nowhere does the grey jump: the slope stays below that of the steepest layer times that of the
// turbulence, about 0.7 * 40 * 30.
TEST(Texture, MarbleIsContinuous) {
  Points line;
  constexpr double step = 1e-5;
  for (int i = 0; i < scaled(400000, 20000); i++) line.add(1.3 + i * step, 0.7 - 0.5 * i * step, -2.2 + 0.3 * i * step);
  const std::vector<float> grey = values(LaneFunction::marble, line);
  double jump = 0;
  for (std::size_t i = 1; i < grey.size(); i++) jump = std::max(jump, double{std::abs(grey[i] - grey[i - 1])});
  EXPECT_LT(jump, 850 * step);
  EXPECT_GT(jump, 10 * step);
}

}  // namespace
}  // namespace penumbra::test
