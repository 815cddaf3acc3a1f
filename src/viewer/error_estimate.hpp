// Estimates from the picture itself how far it is from the converged one: the root mean square error over all colours,
// each clamped to 0..1.
//
// A sequence is observed at every power of two. In the mean square, the mean of n rays differs from that of their first
// half by a quarter of the difference between the two halves, and that difference is 4 (r - 1) V, where V is the
// variance of the mean of n rays and r the factor by which it falls when n doubles (rendering/noise_estimate.hpp). r is
// the ratio of two successive differences. For sets drawn afresh with four times the rays, the difference is V (1 + 4)
// if the rays are independent, and less if they are better than that.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace penumbra {

class ErrorEstimate {
 public:
  // Takes the picture with this number of rays per pixel. `afresh`: none of its rays was in the picture before it.
  void add(std::uint32_t rays, std::span<const float> colors, bool afresh);

  // The error of the picture of the last call; nothing while there is too little to compare.
  std::optional<double> error() const;

 private:
  std::uint32_t rays_ = 0;        // of the last call
  std::uint32_t known_rays_ = 0;  // of `colors_`
  std::vector<float> colors_;
  double difference_ = -1;  // mean square of half the difference of the halves at `known_rays_`; below 0: unknown
  double rate_ = 2;
  double variance_ = -1;  // at `known_rays_`; below 0: unknown
};

}  // namespace penumbra
