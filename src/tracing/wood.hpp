// Solid wood (Perlin 1985): rings round the x axis of the object's space, ten to a unit, light early wood and dark late
// wood with a sharp edge between. Slow noise makes the rings uneven; fine noise, drawn out along z, is the grain.
#pragma once

#include "tracing/noise.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Where in its ring a point is: 0 at the inner edge, 1 at the outer.
inline Floats wood_ring(Float3 p) {
  const Floats radius = sqrt(p.y * p.y + p.z * p.z);
  const Floats rings = Floats(10) * (radius + Floats(0.03f) * noise3(p * Floats(2))) + Floats(0.035f);
  return rings - floor(rings);
}

inline Float3 wood_color(Float3 p) {
  const Mask light = wood_ring(p) < Floats(0.6f);
  const Float3 early{0.70f, 0.30f, 0.15f}, late{0.20f, 0.05f, 0.02f};
  const Floats grain = Floats(0.05f) * noise3({p.x * Floats(60), p.y * Floats(45), p.z * Floats(16)});
  const Float3 color = select(light, early, late);
  return {color.x + grain, color.y + grain, max(color.z + grain, Floats(0))};
}

}  // namespace penumbra::PENUMBRA_KERNEL
