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

PENUMBRA_INLINE Float3 point_on(const FrameQuadLight& light, const auto& read, Pair random) {
  const Floats s = Floats(2) * random.u - Floats(1);
  const Floats t = Floats(2) * random.v - Floats(1);
  return read(light.center) + read(light.u) * s + read(light.v) * t;
}
PENUMBRA_INLINE Float3 radiance(const FrameQuadLight&, const auto&, Float3 color, Float3) { return color; }

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
