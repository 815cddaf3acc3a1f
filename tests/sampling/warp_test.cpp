// The warps give uniform density: chi-square over cells of equal area of the disk and of equal volume of the ball. One
// seed in a million fails.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/test_scale.hpp"
#include "probes/lane_probes.hpp"
#include "rendering/isa.hpp"
#include "sampling/statistics.hpp"

namespace penumbra::test {
namespace {

constexpr int count = scaled(1 << 20, 1 << 16);

std::vector<float> random_numbers(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<float> list;
  for (int i = 0; i < count; i++) list.push_back(static_cast<float>(random() >> 8) * 0x1p-24f);
  return list;
}

std::size_t cell(double fraction, int cells) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(fraction * cells), 0, cells - 1));
}

double turns(double y, double x) {
  const double angle = std::atan2(y, x) / (2 * std::numbers::pi);
  return angle < 0 ? angle + 1 : angle;
}

TEST(Warps, DiskIsUniform) {
  const std::vector<float> u = random_numbers(1), v = random_numbers(2), w(u.size());
  const LaneProbes& probes = probes_of(*usable_kernels().back());
  std::vector<float> x(u.size()), y(u.size());
  probes.evaluate(LaneFunction::disk_x, u, v, w, x);
  probes.evaluate(LaneFunction::disk_y, u, v, w, y);
  std::vector<int> counts(16 * 16), squares(32 * 32);
  int inside_square = 0;
  for (std::size_t i = 0; i < u.size(); i++) {
    const double r2 = double{x[i]} * x[i] + double{y[i]} * y[i];
    ASSERT_LE(r2, 1 + 1e-6);
    counts[cell(r2, 16) * 16 + cell(turns(y[i], x[i]), 16)]++;
    // The square inside the disk again, in cells of x and y.
    const double side = 2 * std::numbers::sqrt2 / 2;
    const double sx = x[i] / side + 0.5, sy = y[i] / side + 0.5;
    if (sx < 0 || sx >= 1 || sy < 0 || sy >= 1) continue;
    inside_square++;
    squares[cell(sx, 32) * 32 + cell(sy, 32)]++;
  }
  const double limit = normal_limit(3);
  EXPECT_LT(chi_square_deviation(counts), limit);
  EXPECT_LT(chi_square_deviation(squares), limit);
  const double share = 2 / std::numbers::pi;
  EXPECT_NEAR(inside_square, count * share, limit * std::sqrt(count * share * (1 - share)));
}

TEST(Warps, BallIsUniform) {
  const std::vector<float> u = random_numbers(3), v = random_numbers(4), w = random_numbers(5);
  const LaneProbes& probes = probes_of(*usable_kernels().back());
  std::vector<float> x(u.size()), y(u.size()), z(u.size());
  probes.evaluate(LaneFunction::ball_x, u, v, w, x);
  probes.evaluate(LaneFunction::ball_y, u, v, w, y);
  probes.evaluate(LaneFunction::ball_z, u, v, w, z);
  std::vector<int> counts(8 * 8 * 8), cubes(10 * 10 * 10);
  for (std::size_t i = 0; i < u.size(); i++) {
    const double r = std::sqrt(double{x[i]} * x[i] + double{y[i]} * y[i] + double{z[i]} * z[i]);
    ASSERT_LE(r, 1 + 1e-6);
    counts[(cell(r * r * r, 8) * 8 + cell((z[i] / r + 1) / 2, 8)) * 8 + cell(turns(y[i], x[i]), 8)]++;
    const double side = 2 / std::numbers::sqrt3;
    const double sx = x[i] / side + 0.5, sy = y[i] / side + 0.5, sz = z[i] / side + 0.5;
    if (sx < 0 || sx >= 1 || sy < 0 || sy >= 1 || sz < 0 || sz >= 1) continue;
    cubes[(cell(sx, 10) * 10 + cell(sy, 10)) * 10 + cell(sz, 10)]++;
  }
  const double limit = normal_limit(2);
  EXPECT_LT(chi_square_deviation(counts), limit);
  EXPECT_LT(chi_square_deviation(cubes), limit);
}

}  // namespace
}  // namespace penumbra::test
