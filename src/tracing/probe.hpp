// Single rays and what they hit, for whoever asks the world ray by ray; inside the kernels, how such rays are packed.
#pragma once

#include <cstdint>
#ifdef PENUMBRA_LANES
#include "geometry/rays.hpp"
#endif

namespace penumbra {

struct ProbeRay {
  float origin[3], direction[3];  // direction of any length
  float time, farthest;
};
struct ProbeHit {
  float distance;  // infinity where nothing is nearer than `farthest`
  std::uint32_t surface;
  float normal[3], point[3];
};

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

struct ProbePacket {
  Rays rays;
  Floats farthest;
  Mask active;
  std::size_t size;
};

inline ProbePacket load_packet(const ProbeRay* rays, std::size_t left) {
  alignas(64) float columns[8][lane_count] = {};
  const std::size_t size = left < lane_count ? left : lane_count;
  for (std::size_t i = 0; i < size; i++) {
    for (int axis = 0; axis < 3; axis++) {
      columns[axis][i] = rays[i].origin[axis];
      columns[3 + axis][i] = rays[i].direction[axis];
    }
    columns[6][i] = rays[i].time;
    columns[7][i] = rays[i].farthest;
  }
  ProbePacket packet;
  packet.rays.origin = {load(columns[0]), load(columns[1]), load(columns[2])};
  packet.rays.direction = {load(columns[3]), load(columns[4]), load(columns[5])};
  packet.rays.time = load(columns[6]);
  packet.rays.unit = false;
  packet.farthest = load(columns[7]);
  packet.active = mask_from_bits(0xffffffffu >> (32 - size));
  packet.size = size;
  return packet;
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
