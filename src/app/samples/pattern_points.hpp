// The points of a pattern as a render uses them, for the figures of `penumbra samples`.
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "sampling/figures/plane_point.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

// Two dimensions of a sample: one of the eye ray's and the next, or a later pair, which is named by a hash (see
// Sampler::pair); one such pair represents all.
struct DimensionPair {
  std::string_view name;
  std::uint32_t first;
};

inline constexpr DimensionPair dimension_pairs[] = {
    {"pixel", pixel_x}, {"lens", lens_radius}, {"light", first_light_radius}, {"gloss", 0x2c1b3c6du}};

class PatternPoints {
 public:
  PatternPoints(const Kernel& kernel, Pattern pattern, const DimensionPair& dimensions)
      : kernel_(kernel), pattern_(pattern), dimensions_(dimensions) {}

  // The points of one pixel that has `count` samples.
  std::vector<PlanePoint> points(std::size_t count, std::uint32_t seed, int x, int y);

 private:
  // The frame that a render with `count` rays per pixel would use, made once.
  const Frame& frame_for(std::size_t count, std::uint32_t seed);

  const Kernel& kernel_;
  Pattern pattern_;
  DimensionPair dimensions_;
  std::map<std::pair<std::size_t, std::uint32_t>, Frame> frames_;
};

}  // namespace penumbra
