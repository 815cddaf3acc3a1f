#include "image/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

float difference(float a, float b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0.0f;
  if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<float>::infinity();
  return std::abs(a - b);
}

std::vector<float> pixel_differences(const Image& a, const Image& b) {
  std::vector<float> result(a.rgb.size() / 3);
  for (std::size_t i = 0; i < result.size(); i++) {
    for (std::size_t c = 3 * i; c < 3 * i + 3; c++) result[i] = std::max(result[i], difference(a.rgb[c], b.rgb[c]));
  }
  return result;
}

float largest_finite(std::span<const float> differences) {
  float largest = 0;
  for (const float d : differences) {
    if (std::isfinite(d)) largest = std::max(largest, d);
  }
  return largest;
}

std::size_t count_beyond(std::span<const float> differences, float threshold) {
  return static_cast<std::size_t>(
      std::count_if(differences.begin(), differences.end(), [&](float d) { return d > threshold || std::isinf(d); }));
}

std::size_t count_not_finite(const Image& image) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    count += !std::all_of(&image.rgb[i], &image.rgb[i] + 3, [](float v) { return std::isfinite(v); });
  }
  return count;
}

ErrorFigures error_figures(const Image& a, const Image& b) {
  double sum = 0, sum_of_squares = 0, peak = 1;
  for (std::size_t i = 0; i < a.rgb.size(); i++) {
    const double d = difference(a.rgb[i], b.rgb[i]);
    sum += d;
    sum_of_squares += d * d;
    if (std::isfinite(a.rgb[i]) && std::isfinite(b.rgb[i])) peak = std::max<double>({peak, a.rgb[i], b.rgb[i]});
  }
  const auto count = static_cast<double>(a.rgb.size());
  const double rmse = std::sqrt(sum_of_squares / count);
  return {sum / count, rmse, 20 * std::log10(peak / rmse)};
}

std::vector<float> luma(const Image& image) {
  // Written so that NaN becomes 0.
  const auto clamped = [](float v) { return v > 0 ? (v < 1 ? v : 1.0f) : 0.0f; };
  std::vector<float> result(image.rgb.size() / 3);
  for (std::size_t i = 0; i < result.size(); i++) {
    const float* rgb = &image.rgb[3 * i];
    result[i] = 0.299f * clamped(rgb[0]) + 0.587f * clamped(rgb[1]) + 0.114f * clamped(rgb[2]);
  }
  return result;
}

}  // namespace penumbra
