// All rays of one sample: what a pixel saw, and why.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>

#include "tracing/kernel.hpp"

namespace penumbra {

struct RayTree {
  std::deque<RecordedRay> rays;  // the eye ray first, every ray after the one whose hit sent it
  std::uint64_t left_out = 0;    // rays beyond the limit, which are not kept
  std::array<float, 3> color{};  // of the sample; what rays that go on alone bring is rounded before it is added
  bool given_up = false;         // there are even more rays than are sent: what came back is not complete
};

// So many rays are sent beyond those that are kept.
inline constexpr std::uint64_t most_left_out = std::uint64_t{1} << 20;

// Traces sample `sample` of pixel (x, y), for a picture of `count` samples per pixel, as render_samples does. Keeps the
// first `most` rays.
RayTree trace_sample(const Frame& frame, const Kernel& kernel, int x, int y, std::uint32_t sample, std::uint32_t count,
                     std::size_t most = std::size_t{1} << 16);

// The colour of a ray, summed again from the rays below it in the order of tracing/trace.hpp: equal to its
// `came_back` to the last bit, unless rays were left out. The colour of the sample is equal to that of the eye ray, up
// to rounding where some rays go on alone.
std::array<float, 3> sum_of(const RayTree& tree, std::size_t ray);

// What the sample adds to the film: its colour, rounded as exact sums require.
std::array<float, 3> value_in_film(const Frame& frame, const RayTree& tree);

// The rays as text. One line per ray, indented by depth, with every number to its last digit; then the sum.
std::string ray_tree_text(const Frame& frame, const RayTree& tree, int x, int y, std::uint32_t sample);

}  // namespace penumbra
