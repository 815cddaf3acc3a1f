// Wood: its rings against a twin written out plainly, and its colours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/test_scale.hpp"
#include "tracing/texture_points.hpp"

namespace penumbra::test {
namespace {

constexpr float early_red = 0.45f;  // between early and late wood

// Outwards from the x axis, at any x and in any direction, ring k begins at r = k / 10, give or take the warp of 0.03
// times noise (at most 1.1 by size) and the ring's phase of 0.035; there is no other edge but that of its late wood.
TEST(Texture, WoodHasTenRingsToAUnitRoundTheXAxis) {
  constexpr int lines = scaled(400, 40), steps = 4000;
  constexpr double step = 0.001, warp = 0.033 + step;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-20, 20), turn(0, 2 * std::numbers::pi);
  int light = 0, total = 0;
  for (int line = 0; line < lines; line++) {
    const double x = place(random), angle = turn(random);
    Points points;
    for (int i = 0; i < steps; i++) points.add(x, i * step * std::cos(angle), i * step * std::sin(angle));
    const std::vector<float> red = values(LaneFunction::wood_red, points);
    int ring = 0;
    for (std::size_t i = 1; i < steps; i++) {
      const double r = static_cast<double>(i) * step;
      light += red[i] > early_red;
      total++;
      if (red[i - 1] < early_red && red[i] > early_red) {
        ring++;
        // The phase is below zero where the warp is: then the first edge is that of ring 0.
        if (ring == 1 && r < 0.05) ring = 0;
        ASSERT_NEAR(r, (ring - 0.035) / 10, warp) << "ring " << ring << ", x " << x << ", angle " << angle;
      }
    }
    EXPECT_NEAR(ring, 40, 1);
  }
  // Neighbouring points of a line are not independent, its 40 rings are about so.
  EXPECT_NEAR(light / static_cast<double>(total), 0.6, share_tolerance(0.6, std::size_t{40} * lines));
}

TEST(Texture, WoodIsOfTwoColoursWithGrain) {
  const Points points = random_points(scaled(100000, 5000), 100);
  std::vector<float> channel[3];
  for (int c = 0; c < 3; c++) channel[c] = values(wood_channels[c], points);
  std::vector<float> grain;
  for (std::size_t i = 0; i < points.size(); i++) {
    const bool light = channel[0][i] > early_red;
    const float base[3] = {light ? 0.70f : 0.20f, light ? 0.30f : 0.05f, light ? 0.15f : 0.02f};
    grain.push_back(channel[0][i] - base[0]);
    EXPECT_LE(std::abs(grain.back()), 0.055f);
    for (int c = 1; c < 3; c++) EXPECT_NEAR(channel[c][i], std::max(base[c] + grain.back(), 0.0f), 1e-6);
  }
  const Moments m = moments(grain);
  EXPECT_NEAR(m.mean, 0, 5 * m.deviation / std::sqrt(static_cast<double>(grain.size())));
  EXPECT_NEAR(m.deviation, 0.0133, 0.002);  // as in the published picture
}

}  // namespace
}  // namespace penumbra::test
