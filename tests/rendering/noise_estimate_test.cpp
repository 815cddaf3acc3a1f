// The error of a pixel, estimated from its own samples and those around it: honest where the answer is known.
#include "rendering/noise_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "base/test_scale.hpp"

namespace penumbra::test {
namespace {

// Independent samples of variance s: the estimated variance of the mean of n is s / n, before and after doubling n. A
// mean over W windows of estimates from some 25 differences each has a relative standard error below sqrt(2 / (10 W)).
TEST(NoiseEstimate, OfIndependentSamples) {
  constexpr int windows = scaled(400, 100);
  std::mt19937 random(7);
  const auto sum_of = [&](std::uint32_t samples) {
    ColorSum sum{};
    for (std::uint32_t i = 0; i < samples; i++) {
      for (double& c : sum) c += static_cast<double>(random()) / 4294967296.0;
    }
    return sum;
  };
  double after_first = 0, after_doubling = 0;
  constexpr std::size_t middle = (noise_window_size + 1) * noise_window_size / 2;
  for (int i = 0; i < windows; i++) {
    NoiseWindow window{};
    const auto for_block = [&](auto&& change) {
      for (int y = -2; y <= 2; y++) {
        for (int x = -2; x <= 2; x++) change(window[middle + static_cast<std::size_t>(y * noise_window_size + x)]);
      }
    };
    std::vector<ColorSum> sums;
    for_block([&](PixelNoise& pixel) {
      const std::array<ColorSum, 4> blocks{sum_of(4), sum_of(4), sum_of(4), sum_of(4)};
      sums.push_back(blocks[0] + blocks[1] + blocks[2] + blocks[3]);
      pixel = first_noise(blocks, 4);
    });
    after_first += variance(window, middle, observed_rates(window, rates_of_independent_samples)[middle])[1];
    std::size_t k = 0;
    for_block([&](PixelNoise& pixel) {
      const ColorSum a = sum_of(8), b = sum_of(8);
      const SquaredDifference parts = squared_difference(a, b, 8);
      pixel = doubled_noise(pixel, sums[k++], a + b, &parts);
    });
    after_doubling += variance(window, middle, observed_rates(window, rates_of_independent_samples)[middle])[1];
  }
  const double tolerance = 5 * std::sqrt(2.0 / (10 * windows));
  EXPECT_NEAR(after_first / windows * 12 * 16, 1, tolerance);
  EXPECT_NEAR(after_doubling / windows * 12 * 32, 1, tolerance);
}

// If halves and quarters differ as at rate r, the variance is V = d / (4 (r - 1)).
TEST(NoiseEstimate, OfNets) {
  NoiseWindow window{};
  constexpr std::size_t middle = (noise_window_size + 1) * noise_window_size / 2;
  const auto with_rate = [&](float rate) {
    for (PixelNoise& pixel : window) {
      pixel.level = 5;
      pixel.halves_known = 2;
      pixel.halves = {4 * (rate - 1), {4 * (rate - 1), 0, 0}};
      pixel.quarters = pixel.halves * rate;
    }
    return std::pair(squared_error(window, middle, rate), variance(window, middle, rate));
  };
  for (const float rate : {2.0f, 2.5f, 3.0f}) {
    const auto [error, rgb] = with_rate(rate);
    EXPECT_NEAR(error, 1, 1e-5);
    EXPECT_NEAR(rgb[0], 1, 1e-5);
    EXPECT_EQ(rgb[1], 0);
  }
}

// The result is one part in eleven the rate in the differences of the pixels around, the rest the expected rate. The
// former is the ratio of the sums of the differences, weighted by the pixels' numbers of samples.
TEST(NoiseEstimate, ObservesRates) {
  NoiseWindow window{};
  constexpr std::size_t middle = (noise_window_size + 1) * noise_window_size / 2;
  const NoiseRates rates{2, 2.5f, 4};
  EXPECT_EQ(observed_rates(window, rates)[middle], 2.5f);
  double halves = 0, quarters = 0;
  for (int y = -3; y <= 3; y++) {
    for (int x = -3; x <= 3; x++) {
      PixelNoise& pixel = window[middle + static_cast<std::size_t>(y * noise_window_size + x)];
      pixel.level = static_cast<std::uint8_t>(4 + (x + y + 6) % 3);
      pixel.halves_known = 1;
      pixel.halves.clamped = static_cast<float>(1 + x * x);
      pixel.quarters.clamped = static_cast<float>(8 + y);
      if (std::abs(x) > noise_reach || std::abs(y) > noise_reach) continue;
      halves += pixel.samples() * pixel.halves.clamped;
      quarters += pixel.samples() * pixel.quarters.clamped;
    }
  }
  EXPECT_NEAR(observed_rates(window, rates)[middle], (quarters / halves + 10 * 2.5) / 11, 1e-5);
  EXPECT_EQ(observed_rates(window, {2, 2.1f, 2.12f})[middle], 2.12f);
}

// Colours beyond 0..1 look the same, so there is no error.
TEST(NoiseEstimate, Clamps) {
  const SquaredDifference d = squared_difference({20, 8, -4}, {40, 12, -8}, 10);
  EXPECT_NEAR(d.clamped, 0.2 * 0.2 / 3, 1e-6);
  EXPECT_NEAR(d.rgb[0], 4, 1e-6);
}

}  // namespace
}  // namespace penumbra::test
