// Sample points as the packets draw them.
#pragma once

#include <vector>

#include "rendering/isa.hpp"
#include "tracing/kernel.hpp"

namespace penumbra::test {

// All that a frame needs for sample points.
inline Frame sampling_frame(Pattern pattern, std::uint32_t count, std::uint32_t seed = 0) {
  Frame frame;
  frame.options.pattern = pattern;
  frame.options.seed = seed;
  frame.options.rays_per_pixel = static_cast<int>(count);
  frame.sobol = make_sobol_table(count, seed);
  return frame;
}

struct Points {
  std::vector<float> u, v;
};

// Two dimensions of the sample: two joint ones, or a padded pair. Padded ones are named by hashes, never by small
// numbers; what spreads a ray has neighbouring names.
struct Dimensions {
  std::uint32_t first;
  bool joint;
};
inline constexpr Dimensions all_dimensions[] = {{0, true},
                                                {2, true},
                                                {4, true},
                                                {5, true},
                                                {0x2c1b3c6du, false},
                                                {0x2c1b3c6eu, false},
                                                {0x00012345u, false},
                                                {0xdeadbeefu, false}};

inline Points points_of(const Frame& frame, int x, int y, Dimensions dimensions, std::size_t count,
                        const Kernel& kernel = *usable_kernels().back()) {
  Points points{std::vector<float>(count), std::vector<float>(count)};
  kernel.sample_points(frame, x, y, dimensions.first, dimensions.joint, points.u, points.v);
  return points;
}

}  // namespace penumbra::test
