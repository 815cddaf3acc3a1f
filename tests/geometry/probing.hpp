// Many rays through one kernel.
#pragma once

#include <memory>
#include <vector>

#include "probes/lane_probes.hpp"
#include "rendering/isa.hpp"

namespace penumbra::test {

inline std::vector<ProbeHit> hits_of(const Kernel& kernel, const World& world, const std::vector<ProbeRay>& rays) {
  std::vector<ProbeHit> hits(rays.size());
  kernel.intersect(world, rays, hits);
  return hits;
}

inline std::vector<char> blocked_of(const Kernel& kernel, const World& world, const std::vector<ProbeRay>& rays) {
  const std::unique_ptr<bool[]> blocked(new bool[rays.size()]);
  probes_of(kernel).occluded(world, rays, {blocked.get(), rays.size()});
  return {blocked.get(), blocked.get() + rays.size()};
}

}  // namespace penumbra::test
