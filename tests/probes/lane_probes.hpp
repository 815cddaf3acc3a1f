// Packet functions for tests, compiled for each instruction set like the kernels.
#pragma once

#include <cstdint>
#include <span>

#include "tracing/kernel.hpp"

namespace penumbra {

enum class LaneFunction {
  sine,
  cosine,
  log2,
  exp2,
  power,
  whole_power,   // a to the integer power b
  common_power,  // the same with one power for all lanes: that of the first
  acos_turns,
  disk_x,
  disk_y,
  ball_x,
  ball_y,
  ball_z,
  noise,
  // Textures of the point (a, b, c), channel by channel, and the border of a stone as in StoneCell.
  wood_red,
  wood_green,
  wood_blue,
  marble,
  stone_red,
  stone_green,
  stone_blue,
  stone_border
};

struct LaneProbes {
  // Whether anything blocks each ray.
  void (*occluded)(const World&, std::span<const ProbeRay>, std::span<bool>);
  // Elementary functions and warps: out[i] = function(a[i], b[i], c[i]).
  void (*evaluate)(LaneFunction function, std::span<const float> a, std::span<const float> b, std::span<const float> c,
                   std::span<float> out);
  // Where each index goes in the permutation of 0 .. length-1 named by the key at the same position.
  void (*permute)(std::span<std::uint32_t> index, std::uint32_t length, std::span<const std::uint32_t> key);
};

namespace lanes4 {
extern const LaneProbes probes;
}
namespace lanes8 {
extern const LaneProbes probes;
}
namespace lanes16 {
extern const LaneProbes probes;
}

namespace test {

// The probes of the kernel's instruction set.
const LaneProbes& probes_of(const Kernel& kernel);

}  // namespace test
}  // namespace penumbra
