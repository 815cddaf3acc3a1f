// Which sample patterns there are, and what a pattern needs to know: sample points are a pure function of
// (pixel, index, count, dimension, seed), never a state.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace penumbra {

enum class Pattern : std::uint8_t { random, sobol };

inline constexpr std::string_view pattern_names[] = {"random", "sobol"};
inline constexpr Pattern default_pattern = Pattern::sobol;

// Whether the points depend on how many there will be, so that a pixel cannot go on to more later.
constexpr bool needs_count(Pattern) { return false; }

// The pattern of that name, or nothing.
std::optional<Pattern> pattern_from_name(std::string_view name);

// The joint dimensions of an eye ray: one jointly scrambled sequence.
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

// The first `size` points of the Owen-scrambled Sobol sequence in the joint dimensions, values[dimension * size +
// index] as 32-bit fractions. Read only once made; shared by all threads.
struct SobolTable {
  std::uint32_t size = 0;  // a multiple of 16
  std::vector<std::uint32_t> values;
};

inline constexpr std::uint32_t largest_sobol_table = 1u << 16;

// A table long enough for `count` samples a pixel (or the largest there is), scrambled by `seed`.
SobolTable make_sobol_table(std::uint32_t count, std::uint32_t seed);

}  // namespace penumbra
