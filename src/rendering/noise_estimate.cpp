#include "rendering/noise_estimate.hpp"

#include <algorithm>

namespace penumbra {
namespace {

// How much the rate that is expected weighs against the one observed. Observed rates are noisy, and a wrong one costs
// more rays than the expected one.
constexpr float weight_of_expected_rate = 10;

// The least share of a pixel's own estimate that counts, however still its neighbours are.
constexpr float own_share = 0.5f;

float power(float base, int exponent) {
  float result = 1;
  for (int i = 0; i < exponent; i++) result *= base;
  for (int i = 0; i > exponent; i--) result /= base;
  return result;
}

// Calls `visit(pixel, dx, dy)` for the pixels at most `reach` away.
template <class Visit>
void for_neighbours(const NoiseWindow& window, std::size_t place, int reach, const Visit& visit) {
  const PixelNoise* own = &window[place];
  for (int dy = -reach; dy <= reach; dy++) {
    for (int dx = -reach; dx <= reach; dx++) {
      const PixelNoise& pixel = own[dy * noise_window_size + dx];
      if (pixel.halves_known > 0) visit(pixel, dx, dy);
    }
  }
}

float observed_rate(const NoiseWindow& window, std::size_t place, const NoiseRates& rates) {
  float halves = 0, quarters = 0;
  for_neighbours(window, place, noise_reach, [&](const PixelNoise& pixel, int, int) {
    const auto samples = static_cast<float>(pixel.samples());
    halves += samples * pixel.halves.clamped;
    quarters += samples * pixel.quarters.clamped;
  });
  if (!(halves > 0)) return rates.expected;
  const float rate = (quarters / halves + weight_of_expected_rate * rates.expected) / (1 + weight_of_expected_rate);
  return std::clamp(rate, rates.lowest, rates.highest);
}

// From the three differences of one pixel.
SquaredDifference own_variance(const PixelNoise& pixel, float rate) {
  const float by_halves = 1 / (4 * (rate - 1));
  const auto known = static_cast<float>(pixel.halves_known);
  SquaredDifference sum = pixel.halves * by_halves;
  sum += pixel.quarters * (known * by_halves / rate);
  return sum * (1 / (1 + known));
}

}  // namespace

ColorSum operator+(const ColorSum& a, const ColorSum& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
ColorSum operator-(const ColorSum& a, const ColorSum& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

SquaredDifference& SquaredDifference::operator+=(const SquaredDifference& other) {
  clamped += other.clamped;
  for (std::size_t c = 0; c < 3; c++) rgb[c] += other.rgb[c];
  return *this;
}

SquaredDifference operator*(const SquaredDifference& d, float factor) {
  return {d.clamped * factor, {d.rgb[0] * factor, d.rgb[1] * factor, d.rgb[2] * factor}};
}

SquaredDifference squared_difference(const ColorSum& a, const ColorSum& b, double samples) {
  SquaredDifference result;
  for (std::size_t c = 0; c < 3; c++) {
    const double x = a[c] / samples, y = b[c] / samples;
    const double clamped = std::clamp(x, 0.0, 1.0) - std::clamp(y, 0.0, 1.0);
    result.clamped += static_cast<float>(clamped * clamped / 3);
    result.rgb[c] = static_cast<float>((x - y) * (x - y));
  }
  return result;
}

PixelNoise first_noise(const std::array<ColorSum, 4>& blocks, int level) {
  const double samples = static_cast<double>(1u << level) / 4;
  PixelNoise noise;
  noise.halves = squared_difference(blocks[0] + blocks[1], blocks[2] + blocks[3], 2 * samples);
  noise.quarters = squared_difference(blocks[0], blocks[1], samples);
  noise.quarters += squared_difference(blocks[2], blocks[3], samples);
  noise.quarters = noise.quarters * 0.5f;
  noise.halves_known = 2;
  noise.level = static_cast<std::uint8_t>(level);
  return noise;
}

PixelNoise doubled_noise(const PixelNoise& old, const ColorSum& before, const ColorSum& added,
                         const SquaredDifference* added_quarters) {
  PixelNoise noise;
  noise.halves = squared_difference(before, added, old.samples());
  noise.quarters = old.halves;
  noise.halves_known = 1;
  if (added_quarters) {
    noise.quarters += *added_quarters;
    noise.quarters = noise.quarters * 0.5f;
    noise.halves_known = 2;
  }
  noise.level = static_cast<std::uint8_t>(old.level + 1);
  return noise;
}

NoiseEstimate estimate_noise(const NoiseWindow& window, std::size_t place, const NoiseRates& rates) {
  const PixelNoise& own = window[place];
  const float rate = observed_rate(window, place, rates);
  SquaredDifference smooth;
  float weights = 0;
  for_neighbours(window, place, 1, [&](const PixelNoise& pixel, int dx, int dy) {
    const float weight = (dx == 0 ? 2.0f : 1.0f) * (dy == 0 ? 2.0f : 1.0f);
    smooth += own_variance(pixel, rate) * (weight * power(rate, pixel.level - own.level));
    weights += weight;
  });
  smooth = smooth * (1 / weights);
  return {rate, std::max(smooth.clamped, own_share * own_variance(own, rate).clamped), smooth.rgb};
}

}  // namespace penumbra
