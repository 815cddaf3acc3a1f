// Which sample patterns there are, and what a pattern needs to know: sample points are a pure function of
// (pixel, index, count, dimension, seed), never a state.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace penumbra {

enum class Pattern : std::uint8_t {
  regular,        // a fixed grid, the same in every pixel: what the others are better than
  random,         // independent points
  jittered,       // one point in each of `count` cells of equal area
  multijittered,  // the same, and one point in each of `count` columns and rows
  poisson,        // no two points near each other, no large gap
  halton,         // van der Corput's sequences in prime bases, scrambled
  sobol,          // Sobol's sequence, Owen-scrambled
  bluenoise       // Sobol's sequence, shifted so that the errors of neighbouring pixels cancel
};

inline constexpr std::string_view pattern_names[] = {"regular", "random", "jittered", "multijittered",
                                                     "poisson", "halton", "sobol",    "bluenoise"};
inline constexpr Pattern default_pattern = Pattern::sobol;

// Whether the points depend on how many there will be. The others are sequences: good at every length.
constexpr bool needs_count(Pattern pattern) {
  return pattern == Pattern::regular || pattern == Pattern::jittered || pattern == Pattern::multijittered ||
         pattern == Pattern::poisson;
}

// The pattern of that name, or nothing.
std::optional<Pattern> pattern_from_name(std::string_view name);

// The dimensions of an eye ray, which some patterns handle jointly. All later dimensions have hashes for names.
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
