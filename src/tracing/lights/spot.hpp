// A point that shines into a cone: full up to the inner angle from its axis, none beyond the outer one, and between
// them a smoothstep of the cosine.
#pragma once

#include <cmath>
#include <numbers>

#include "base/vec.hpp"
#include "scene/light.hpp"

namespace penumbra {

struct FrameSpotLight {
  static constexpr bool has_area = false;
  float center[3];
  float axis[3];  // unit
  float cosine_inner, cosine_outer;
};

inline FrameSpotLight frame_light(const SpotLight& l, Vec3 origin) {
  FrameSpotLight light{};
  set3(light.center, l.position - origin);
  set3(light.axis, normalize(l.direction));
  light.cosine_inner = static_cast<float>(std::cos(l.inner_degrees * std::numbers::pi / 180));
  light.cosine_outer = static_cast<float>(std::cos(l.outer_degrees * std::numbers::pi / 180));
  return light;
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Float3 point_on(const FrameSpotLight& light, const auto& read, Pair) { return read(light.center); }

PENUMBRA_INLINE Float3 radiance(const FrameSpotLight& light, const auto& read, Float3 color, Float3 toward_light) {
  const Floats cosine = -dot(toward_light, read(light.axis));
  const Floats outer = read(light.cosine_outer);
  const Floats width = read(light.cosine_inner) - outer;
  const Floats t = min(max((cosine - outer) / max(width, Floats(1e-12f)), Floats(0)), Floats(1));
  const Floats smooth = t * t * (Floats(3) - Floats(2) * t);
  return color * keep(cosine >= outer, smooth);
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
