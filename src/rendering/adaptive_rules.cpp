#include "rendering/adaptive_rules.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

namespace penumbra {
namespace {

// The number of samples of the first round, times the goal. If all samples miss a bright object, which is likely only
// if it covers no more than a few times 1 / samples of the pixel, that share is the pixel's error. Objects that glow
// brighter than white need more samples; one so bright and so small that 4096 samples miss it stays unseen.
constexpr float first_samples_times_goal = 0.15f;
constexpr int fewest_first_level = 4, most_first_level = 12;

float brightest_glow(const Frame& frame) {
  float brightest = *std::max_element(std::begin(frame.background), std::end(frame.background));
  for (const FrameSurface& surface : frame.surfaces) {
    brightest = std::max(brightest, *std::max_element(std::begin(surface.ambient), std::end(surface.ambient)));
  }
  return brightest;
}

int level_of_first_round(const NoiseGoal& goal, const Frame& frame, int most_level) {
  if (goal.first_rays > 0) return std::min(static_cast<int>(std::bit_width(goal.first_rays - 1)), most_level);
  const float wanted = first_samples_times_goal * std::max(1.0f, brightest_glow(frame) / 2);
  int level = fewest_first_level;
  while (level < most_first_level && goal.error * static_cast<float>(1 << level) < wanted) level++;
  return std::min(level, most_level);
}

}  // namespace

AdaptiveRules::AdaptiveRules(const NoiseGoal& goal, const Frame& frame)
    : goal_squared(goal.error * goal.error),
      rates(frame.settings.pattern == Pattern::random ? rates_of_independent_samples : rates_of_nets),
      most_level(static_cast<int>(std::bit_width(goal.most_rays)) - 1),
      first_level(level_of_first_round(goal, frame, most_level)) {}

int AdaptiveRules::expected_level(const PixelNoise& noise) const {
  const float falls_by = 1 / rates.expected;
  float squared_error = noise.halves.clamped / (4 * (rates.expected - 1));
  int level = first_level;
  for (; level < most_level && is_worth_more(squared_error, level); level++) squared_error *= falls_by;
  return level;
}

}  // namespace penumbra
