// Sample points as the packets draw them.
#pragma once

#include <string>
#include <vector>

#include "rendering/isa.hpp"
#include "tracing/kernel.hpp"

namespace penumbra::test {

inline constexpr Pattern all_patterns[] = {Pattern::regular, Pattern::random, Pattern::jittered, Pattern::multijittered,
                                           Pattern::poisson, Pattern::halton, Pattern::sobol,    Pattern::bluenoise};
inline constexpr std::size_t pattern_count = std::size(all_patterns);

inline std::string name_of(Pattern pattern) { return std::string(pattern_names[static_cast<int>(pattern)]); }

// A frame with all that sample points need.
inline Frame sampling_frame(Pattern pattern, std::uint32_t count, std::uint32_t seed = 0) {
  Frame frame;
  frame.settings.pattern = pattern;
  frame.settings.seed = seed;
  frame.settings.rays_per_pixel = static_cast<int>(count);
  frame.tables = make_sample_tables(pattern, {count}, seed);
  return frame;
}

struct Points {
  std::vector<float> u, v;
};

// Two dimensions of a sample: two of the eye ray, or a later pair. Later ones are named by hashes, never by small
// numbers; those that spread one ray have consecutive names.
struct Dimensions {
  std::uint32_t first;
  bool joint() const { return first < joint_dimension_count; }
};
inline constexpr Dimensions all_dimensions[] = {{pixel_x},     {lens_radius}, {first_light_radius}, {0x2c1b3c6du},
                                                {0x2c1b3c6eu}, {0x00012345u}, {0xdeadbeefu}};

inline constexpr Dimensions time_dimension{shutter_time};  // v is 0

inline Points points_of(const Frame& frame, int x, int y, Dimensions dimensions, std::size_t count,
                        const Kernel& kernel = *usable_kernels().back()) {
  Points points{std::vector<float>(count), std::vector<float>(count)};
  kernel.sample_points(frame, x, y, dimensions.first, points.u, points.v);
  return points;
}

// The points with begin <= index < end.
inline Points part_of(const Points& points, std::size_t begin, std::size_t end) {
  return {{points.u.begin() + static_cast<std::ptrdiff_t>(begin), points.u.begin() + static_cast<std::ptrdiff_t>(end)},
          {points.v.begin() + static_cast<std::ptrdiff_t>(begin), points.v.begin() + static_cast<std::ptrdiff_t>(end)}};
}

}  // namespace penumbra::test
