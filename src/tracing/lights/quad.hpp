// A parallelogram: every point of it, uniform over its area, shines equally in all directions, to both sides.
#pragma once

#include "base/vec.hpp"
#include "scene/light.hpp"

namespace penumbra {

struct FrameQuadLight {
  static constexpr bool has_area = true;
  float center[3];
  float u[3], v[3];  // the half edges
};

inline FrameQuadLight frame_light(const QuadLight& l, Vec3 origin) {
  FrameQuadLight light{};
  set3(light.center, l.center - origin);
  set3(light.u, l.u);
  set3(light.v, l.v);
  return light;
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Float3 point_on(const FrameQuadLight& light, Pair random) {
  const Floats s = Floats(2) * random.u - Floats(1);
  const Floats t = Floats(2) * random.v - Floats(1);
  return broadcast3(light.center) + broadcast3(light.u) * s + broadcast3(light.v) * t;
}
PENUMBRA_INLINE Float3 radiance(const FrameQuadLight&, Float3 color, Float3) { return color; }

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
