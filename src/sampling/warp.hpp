// Maps the unit square to the shapes over which rays are spread, each with uniform density.
#pragma once

#include "sampling/fraction.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct DiskPoint {
  Floats x, y;
};

// Uniform over the area of the unit disk: r = sqrt(u), angle v turns.
PENUMBRA_INLINE DiskPoint warp_to_disk(Pair p) {
  const SinCos angle = sincos_turns(p.v);
  const Floats r = sqrt(p.u);
  return {r * angle.cosine, r * angle.sine};
}

// Uniform inside the unit ball. The height z has density 3/4 (1 - z^2): its distribution function inverts in closed
// form, z = 2 cos(phi) with cos(3 phi) = 1 - 2w; the rest is a disk of radius sqrt(1 - z^2).
PENUMBRA_INLINE Float3 warp_to_ball(Pair p, Floats w) {
  const Floats turns = acos_turns(Floats(1) - Floats(2) * w) * Floats(1.0f / 3.0f) + Floats(2.0f / 3.0f);
  const Floats z = min(max(Floats(2) * sincos_turns(turns).cosine, Floats(-1)), Floats(1));
  const DiskPoint disk = warp_to_disk(p);
  const Floats radius = sqrt(max(Floats(1) - z * z, Floats(0)));
  return {radius * disk.x, radius * disk.y, z};
}

}  // namespace penumbra::PENUMBRA_KERNEL
