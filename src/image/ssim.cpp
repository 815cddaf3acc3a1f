// The Gaussian window is separable: each row of windows is first summed down the columns, then along the row, in double
// precision, so that the variances (equation 15) can be differences of moments.
#include "image/metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace penumbra {
namespace {

// Weighted means of a, b, a^2, b^2 and ab.
using Moments = std::array<double, 5>;

void add(Moments& sum, double weight, const Moments& moments) {
  for (std::size_t k = 0; k < sum.size(); k++) sum[k] += weight * moments[k];
}

// Gaussian weights of sum 1 for offsets -r..r, r = 5 or the largest that fits into `side`.
std::vector<double> window_weights(int side) {
  const int radius = std::min(5, (side - 1) / 2);
  std::vector<double> weights;
  double sum = 0;
  for (int i = -radius; i <= radius; i++) {
    weights.push_back(std::exp(-i * i / (2 * 1.5 * 1.5)));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

// Equation 13.
double similarity(const Moments& m) {
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  const double mean_a = m[0], mean_b = m[1];
  const double variance_a = m[2] - mean_a * mean_a, variance_b = m[3] - mean_b * mean_b;
  const double covariance = m[4] - mean_a * mean_b;
  return (2 * (mean_a * mean_b) + c1) * (2 * covariance + c2) /
         ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
}

}  // namespace

double ssim(const Image& a, const Image& b) {
  const std::vector<float> luma_a = luma(a), luma_b = luma(b);
  const auto width = static_cast<std::size_t>(a.width), height = static_cast<std::size_t>(a.height);
  const std::vector<double> across = window_weights(a.width), down = window_weights(a.height);
  const std::size_t windows_across = width - across.size() + 1, windows_down = height - down.size() + 1;

  std::vector<Moments> columns(width);
  double sum = 0;
  for (std::size_t y = 0; y < windows_down; y++) {
    std::fill(columns.begin(), columns.end(), Moments{});
    for (std::size_t j = 0; j < down.size(); j++) {
      for (std::size_t x = 0; x < width; x++) {
        const double va = luma_a[(y + j) * width + x], vb = luma_b[(y + j) * width + x];
        add(columns[x], down[j], {va, vb, va * va, vb * vb, va * vb});
      }
    }
    for (std::size_t x = 0; x < windows_across; x++) {
      Moments window{};
      for (std::size_t i = 0; i < across.size(); i++) add(window, across[i], columns[x + i]);
      sum += similarity(window);
    }
  }
  return sum / static_cast<double>(windows_across * windows_down);
}

}  // namespace penumbra
