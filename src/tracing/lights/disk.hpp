// A disk: every point of it, uniform over its area, shines equally in all directions, to both sides.
#pragma once

#include <cmath>

#include "base/vec.hpp"
#include "scene/light.hpp"
#ifdef PENUMBRA_LANES
#include "sampling/warp.hpp"
#endif

namespace penumbra {

struct FrameDiskLight {
  static constexpr bool has_area = true;
  float center[3];
  float u[3], v[3];  // from the centre to the rim, at a right angle
};

// The disk's u and v make a right-handed frame with its direction (Duff et al. 2017).
inline FrameDiskLight frame_light(const DiskLight& l, Vec3 origin) {
  const Vec3 n = normalize(l.direction);
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z);
  const double b = n.x * n.y * a;
  FrameDiskLight light{};
  set3(light.center, l.center - origin);
  set3(light.u, Vec3{1 + sign * n.x * n.x * a, sign * b, -sign * n.x} * l.radius);
  set3(light.v, Vec3{b, sign + n.y * n.y * a, -n.y} * l.radius);
  return light;
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Float3 point_on(const FrameDiskLight& light, const auto& read, Pair random) {
  const DiskPoint disk = warp_to_disk(random);
  return read(light.center) + read(light.u) * disk.x + read(light.v) * disk.y;
}
PENUMBRA_INLINE Float3 radiance(const FrameDiskLight&, const auto&, Float3 color, Float3) { return color; }

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
