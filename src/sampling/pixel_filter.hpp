// Filters of a pixel: how much what lies at a distance from its centre counts in its colour. Places are drawn in
// proportion to the filter, so that all samples count alike, each in one pixel alone (Shirley, "Physically based
// lighting calculations for computer graphics", 1991; Ernst, Stamminger and Greiner, "Filter importance sampling",
// 2006). Where a filter is negative, they count negatively.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace penumbra {

enum class PixelFilter : std::uint8_t {
  box,       // the pixel itself, as the lecture has it
  triangle,  // falls to zero at the centres of the next pixels
  gaussian,  // standard deviation 1/2 pixel, lowered to zero at 3/2
  mitchell   // B = C = 1/3, up to 2 pixels away (Mitchell and Netravali 1988): sharpens edges
};
inline constexpr std::string_view pixel_filter_names[] = {"box", "triangle", "gaussian", "mitchell"};

// A filter along one axis as steps that are drawn equally often.
struct FilterSteps {
  static constexpr std::uint32_t count = 512;
  std::array<float, count + 1> ends{};  // of the steps, in pixels from the centre
  std::uint32_t negative = 0;           // so many at either end are negative
  float weight = 1, negative_weight = 0;
};

// Not for the box. The same numbers on any machine.
FilterSteps make_filter_steps(PixelFilter filter);

}  // namespace penumbra

#ifdef PENUMBRA_LANES
#include "base/lane_math.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct FilteredPlace {
  Floats offset, weight;  // from the centre of the pixel
};

PENUMBRA_INLINE FilteredPlace filtered_place(const FilterSteps& steps, Floats random) {
  const Floats scaled = random * Floats(static_cast<float>(FilterSteps::count));
  const Floats below = min(floor(scaled), Floats(static_cast<float>(FilterSteps::count - 1)));
  const Ints step = truncate(below);
  const Floats begin = gather(steps.ends.data(), step), end = gather(steps.ends.data() + 1, step);
  const Mask positive = ~(step < Ints(steps.negative)) & (step < Ints(FilterSteps::count - steps.negative));
  return {begin + (scaled - below) * (end - begin),
          select(positive, Floats(steps.weight), Floats(steps.negative_weight))};
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
