// Where the rays of an adaptive render go: how many a pixel gets in the first round, and whether it is worth more.
//
// A pixel is worth more samples while its error is above the goal. That alone would spend most rays on the few noisiest
// pixels. For a given number of rays, the error of the whole picture is smallest if one more ray improves all pixels
// equally, so that a pixel's rays are proportional to the square root of its variance. Therefore a pixel also continues
// while a ray improves it by more than it would improve a pixel of ordinary noise that just meets the goal.
#pragma once

#include <cstdint>

#include "rendering/noise_estimate.hpp"
#include "tracing/frame.hpp"

namespace penumbra {

inline constexpr int fewest_first_rays = 16;

struct NoiseGoal {
  // The standard error that no pixel should exceed: the root mean square over r, g, b, each clamped to 0..1.
  float error = 0.01f;
  // The most rays a pixel gets, rounded down to a power of two.
  std::uint32_t most_rays = 1u << 16;
  // What every pixel gets before any gets more, rounded up to a power of two; 0: what the error and the scene suggest.
  std::uint32_t first_rays = 0;
};

// Levels are base-2 logarithms of sample counts.
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
  // The level a pixel may end with, judging by its own noise after the first round.
  int expected_level(const PixelNoise& noise) const;
};

}  // namespace penumbra
