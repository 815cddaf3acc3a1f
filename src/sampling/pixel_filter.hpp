// Filters of a pixel: how much what lies at a distance from its centre counts in its colour. Places are drawn in
// proportion to the filter, so that all samples count alike, each in one pixel alone (Ernst, Stamminger and Greiner,
// "Filter importance sampling", 2006).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace penumbra {

enum class PixelFilter : std::uint8_t {
  box,       // the pixel itself, as the lecture has it
  triangle,  // falls to zero at the centres of the next pixels
  gaussian   // standard deviation 1/2 pixel, lowered to zero at 3/2
};
inline constexpr std::string_view pixel_filter_names[] = {"box", "triangle", "gaussian"};

// A filter along one axis as steps of equal area: where they end, in pixels from the centre.
struct FilterSteps {
  static constexpr std::uint32_t count = 512;
  std::array<float, count + 1> ends{};
};

// Not for the box. The same numbers on any machine.
FilterSteps make_filter_steps(PixelFilter filter);

}  // namespace penumbra

#ifdef PENUMBRA_LANES
#include "base/lane_math.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The distance from the centre of the pixel that a random number in [0, 1) chooses.
PENUMBRA_INLINE Floats filtered_offset(const FilterSteps& steps, Floats random) {
  const Floats scaled = random * Floats(static_cast<float>(FilterSteps::count));
  const Floats below = min(floor(scaled), Floats(static_cast<float>(FilterSteps::count - 1)));
  const Ints step = truncate(below);
  const Floats begin = gather(steps.ends.data(), step), end = gather(steps.ends.data() + 1, step);
  return begin + (scaled - below) * (end - begin);
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
