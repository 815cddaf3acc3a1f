#include "viewer/error_estimate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace penumbra {
namespace {

double clamped(float v) { return v > 0.0f ? std::min(v, 1.0f) : 0.0; }

double mean_square_difference(std::span<const float> a, std::span<const float> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); i++) {
    const double difference = clamped(a[i]) - clamped(b[i]);
    sum += difference * difference;
  }
  return a.empty() ? 0 : sum / static_cast<double>(a.size());
}

}  // namespace

void ErrorEstimate::add(std::uint32_t rays, std::span<const float> colors, bool afresh) {
  const bool comparable = colors_.size() == colors.size();
  rays_ = rays;
  if (afresh) {
    // A single ray goes through another point than any of several.
    if (comparable && known_rays_ > 1 && rays > known_rays_) {
      variance_ = mean_square_difference(colors, colors_) / (1 + static_cast<double>(rays) / known_rays_);
    }
  } else if (!std::has_single_bit(rays)) {
    return;
  } else if (comparable && known_rays_ * 2 == rays) {
    const double before = difference_;
    difference_ = mean_square_difference(colors, colors_);
    if (before > 0 && difference_ > 0) rate_ = std::clamp(before / difference_, 2.0, 8.0);
    variance_ = difference_ / (rate_ - 1);
  }
  known_rays_ = rays;
  colors_.assign(colors.begin(), colors.end());
}

std::optional<double> ErrorEstimate::error() const {
  if (variance_ < 0) return std::nullopt;
  return std::sqrt(variance_ * std::pow(static_cast<double>(known_rays_) / rays_, std::log2(rate_)));
}

}  // namespace penumbra
