// Where the rays of an adaptive render go: how many a pixel gets in the first round, and whether it is worth more.
//
// A pixel is worth more samples while its error is above the goal. That alone would spend most rays on the few noisiest
// pixels. The error of the whole picture is least, for the same number of rays, where one more ray improves all pixels
// alike, so that rays go as the square root of a pixel's variance. Thus a pixel goes on also while a ray improves it by
// more than it would improve a pixel of ordinary noise that just meets the goal.
#pragma once

#include <cstdint>

#include "rendering/noise_estimate.hpp"
#include "tracing/frame.hpp"

namespace penumbra {

struct NoiseGoal {
  // The standard error that no pixel shall exceed: the root of the mean of the squares over r, g, b, each clamped to
  // 0..1.
  float error = 0.01f;
  // The most rays a pixel gets; what is not a power of two is rounded down to one.
  std::uint32_t most_rays = 1u << 16;
};

// Levels are logarithms of numbers of samples, to base 2.
struct AdaptiveRules {
  AdaptiveRules(const NoiseGoal& goal, const Frame& frame);

  // The variance of single samples in a pixel of ordinary noise.
  static constexpr float ordinary_variance = 0.02f;

  float goal_squared;
  NoiseRates rates;
  int most_level, first_level;

  bool is_worth_more(float squared_error, int level) const {
    const float improvement = squared_error / static_cast<float>(1u << level);
    return squared_error > goal_squared || improvement * ordinary_variance > goal_squared * goal_squared;
  }
  // What a pixel may end with, by its own noise after the first round.
  int expected_level(const PixelNoise& noise) const;
};

}  // namespace penumbra
