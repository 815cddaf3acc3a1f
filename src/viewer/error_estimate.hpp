// How far the picture so far is from the finished one, told by itself: the root of the mean square error of all
// colours, each clamped to 0..1.
//
// A sequence is seen at every power of two. The mean of n rays and that of their first half differ by a quarter of what
// the two halves' means differ, and those differ by 4 (r - 1) V in the mean square, V being the variance of the mean of
// n and r the factor by which it falls when n doubles (rendering/noise_estimate.hpp). r is the ratio of two such
// differences in succession. Of sets that are drawn anew with four times the rays, the difference is V (1 + 4) if the
// rays are independent, and less if they are better than that.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace penumbra {

class ErrorEstimate {
 public:
  // Says what the picture of so many rays per pixel is. `afresh`: none of its rays was in the picture before.
  void add(std::uint32_t rays, std::span<const float> colors, bool afresh);

  // For the picture of the last call; nothing while there is too little to compare.
  std::optional<double> error() const;

 private:
  std::uint32_t rays_ = 0;        // of the last call
  std::uint32_t known_rays_ = 0;  // of `colors_`
  std::vector<float> colors_;
  double difference_ = -1;  // the mean square of half the halves' difference at `known_rays_`; below 0: not known
  double rate_ = 2;
  double variance_ = -1;  // at `known_rays_`; below 0: not known
};

}  // namespace penumbra
