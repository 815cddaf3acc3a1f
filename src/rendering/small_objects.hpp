// Objects so small in the picture that the first round of an adaptive render may miss them.
#pragma once

#include <cstdint>

#include "rendering/adaptive_rules.hpp"
#include "scene/scene.hpp"

namespace penumbra {

struct SmallObjects {
  std::uint64_t count = 0;
  std::uint32_t rays = 0;  // per pixel, a power of two: a first round of so many finds them all
};

// The objects that so few rays per pixel may miss, though they are bright enough to change a pixel by more than the
// error. Of the triangles of a group, the group counts.
SmallObjects small_objects(const Scene& scene, double error, std::uint32_t rays);

}  // namespace penumbra
