#include "rendering/noise_estimate.hpp"

#include <algorithm>

namespace penumbra {
namespace {

// The weight of the expected rate, if that of the observed one is 1. Observed rates are noisy, and a wrong one costs
// more rays than the expected one.
constexpr float weight_of_expected_rate = 10;

// A pixel's error is at least this share of its own estimate, however quiet its neighbours are.
constexpr float own_share = 0.5f;

float power(float base, int exponent) {
  float result = 1;
  for (int i = 0; i < exponent; i++) result *= base;
  for (int i = 0; i > exponent; i--) result /= base;
  return result;
}

// A colour as a screen shows it.
double shown(double color) { return std::min(std::max(color, 0.0), 1.0); }

// Estimates of variances at one rate.
struct VarianceRate {
  explicit VarianceRate(float r) : rate(r), per_half(1 / (4 * (r - 1))), per_quarter(1 / r) {}

  // From `part(difference)` of the three differences of one pixel.
  template <class Part>
  float own_variance(const PixelNoise& pixel, const Part& part) const {
    constexpr float mean[] = {1, 1.0f / 2, 1.0f / 3};  // by the number of halves known
    const float quarters = part(pixel.quarters) * static_cast<float>(pixel.halves_known) * per_quarter;
    return (part(pixel.halves) + quarters) * mean[pixel.halves_known] * per_half;
  }

  // The weighted mean over a pixel and its neighbours, scaled to the pixel's number of samples.
  template <class Part>
  float smooth_variance(const NoiseWindow& window, std::size_t index, const Part& part) const {
    const PixelNoise* own = &window[index];
    float sum = 0, weights = 0;
    for (int dy = -1; dy <= 1; dy++) {
      for (int dx = -1; dx <= 1; dx++) {
        const PixelNoise& pixel = own[dy * noise_window_size + dx];
        if (pixel.halves_known == 0) continue;
        const float weight = (dx == 0 ? 2.0f : 1.0f) * (dy == 0 ? 2.0f : 1.0f);
        sum += weight * power(rate, pixel.level - own->level) * own_variance(pixel, part);
        weights += weight;
      }
    }
    return sum / weights;
  }

  float rate, per_half, per_quarter;
};

// Sums over the pixels at most `noise_reach` away.
WindowNumbers sums_around(const WindowNumbers& values) {
  constexpr int first = noise_reach * noise_window_size, end = noise_window_size * noise_window_size - first;
  WindowNumbers columns{}, sums{};
  for (int dy = -noise_reach; dy <= noise_reach; dy++) {
    for (int i = first; i < end; i++) columns[i] += values[i + dy * noise_window_size];
  }
  for (int dx = -noise_reach; dx <= noise_reach; dx++) {
    for (int i = first + noise_reach; i < end - noise_reach; i++) sums[i] += columns[i + dx];
  }
  return sums;
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
  const double weight = 1 / samples;
  SquaredDifference result;
  for (std::size_t c = 0; c < 3; c++) {
    const double x = a[c] * weight, y = b[c] * weight;
    const double clamped = shown(x) - shown(y);
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

WindowNumbers observed_rates(const NoiseWindow& window, const NoiseRates& rates) {
  WindowNumbers halves, quarters;
  for (std::size_t i = 0; i < window.size(); i++) {
    const auto samples = window[i].halves_known > 0 ? static_cast<float>(window[i].samples()) : 0.0f;
    halves[i] = samples * window[i].halves.clamped;
    quarters[i] = samples * window[i].quarters.clamped;
  }
  halves = sums_around(halves);
  quarters = sums_around(quarters);
  WindowNumbers result;
  for (std::size_t i = 0; i < window.size(); i++) {
    const float observed = halves[i] > 0 ? quarters[i] / halves[i] : rates.expected;
    const float rate = (observed + weight_of_expected_rate * rates.expected) / (1 + weight_of_expected_rate);
    result[i] = std::clamp(rate, rates.lowest, rates.highest);
  }
  return result;
}

float squared_error(const NoiseWindow& window, std::size_t index, float rate) {
  const VarianceRate at(rate);
  const auto clamped = [](const SquaredDifference& difference) { return difference.clamped; };
  return std::max(at.smooth_variance(window, index, clamped), own_share * at.own_variance(window[index], clamped));
}

std::array<float, 3> variance(const NoiseWindow& window, std::size_t index, float rate) {
  std::array<float, 3> result;
  for (std::size_t c = 0; c < 3; c++) {
    const auto channel = [c](const SquaredDifference& difference) { return difference.rgb[c]; };
    result[c] = VarianceRate(rate).smooth_variance(window, index, channel);
  }
  return result;
}

}  // namespace penumbra
