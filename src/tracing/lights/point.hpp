// A point that shines equally in all directions.
#pragma once

#include "base/vec.hpp"
#include "scene/light.hpp"

namespace penumbra {

struct FramePointLight {
  static constexpr bool has_area = false;
  float center[3];
};

inline FramePointLight frame_light(const PointLight& l, Vec3 origin) {
  FramePointLight light{};
  set3(light.center, l.position - origin);
  return light;
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Float3 point_on(const FramePointLight& light, const auto& read, Pair) { return read(light.center); }
PENUMBRA_INLINE Float3 radiance(const FramePointLight&, const auto&, Float3 color, Float3) { return color; }

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
