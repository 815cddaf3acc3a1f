// The sample patterns, and what is needed to choose one. Sample points are a pure function of (pixel, index, count,
// dimension, seed), without state.
#pragma once

#include <cstdint>
#include <string_view>

namespace penumbra {

enum class Pattern : std::uint8_t {
  regular,        // a fixed grid, the same in every pixel: the baseline for the others
  random,         // independent points
  jittered,       // one point in each of `count` cells of equal area
  multijittered,  // also one point in each of `count` columns and rows
  poisson,        // no two points near each other, no large gap
  halton,         // van der Corput's sequences in prime bases, scrambled
  sobol,          // Sobol's sequence, Owen-scrambled
  bluenoise       // Sobol's sequence, shifted so that the errors of neighbouring pixels cancel
};

inline constexpr std::string_view pattern_names[] = {"regular", "random", "jittered", "multijittered",
                                                     "poisson", "halton", "sobol",    "bluenoise"};
inline constexpr Pattern default_pattern = Pattern::sobol;

// Whether the points depend on their total number. The other patterns are sequences, good at every length.
constexpr bool needs_count(Pattern pattern) {
  return pattern == Pattern::regular || pattern == Pattern::jittered || pattern == Pattern::multijittered ||
         pattern == Pattern::poisson;
}

// The dimensions of an eye ray, which some patterns handle jointly. All later dimensions are named by hashes.
enum JointDimension : std::uint32_t {
  pixel_x,
  pixel_y,
  lens_radius,
  lens_angle,
  first_light_radius,
  first_light_angle,
  shutter_time,
  joint_dimension_count
};

}  // namespace penumbra
