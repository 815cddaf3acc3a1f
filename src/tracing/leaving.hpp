// How rays leave a hit: from where, on which side, and what lies there (geometry/ray_start.hpp).
#pragma once

#include "geometry/traversal.hpp"
#include "tracing/material.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The largest of the coordinates and distances at hits.
PENUMBRA_INLINE Floats scale_at(const Hits& hits) {
  const Float3 p = hits.point;
  return max(max(abs(p.x), abs(p.y)), max(abs(p.z), hits.distance));
}

// Where rays leave their hits; `behind`: where they arrived behind the surface.
PENUMBRA_INLINE RayStart start_at(const Hits& hits, const Rays& arrived, const Material& material, Mask behind) {
  RayStart start;
  start.arrived = &arrived;
  start.hits = &hits;
  start.place = &hits.place;
  start.one_place = hits.one_place;
  start.the_place = hits.the_place;
  const Floats scale = scale_at(hits);
  const Floats rounding = scale * Floats(rounding_share);
  start.back = rounding + min(hits.slack, rounding);  // of a large shape, other surfaces know only what is near
  start.origin = hits.point - arrived.direction * start.back;
  start.nearest = scale * Floats(-start_share);
  start.behind = behind;
  start.sheet = Mask(false);
  start.opaque = Mask(true);
  if (material.any_transmission) {
    start.opaque = material.transmission == Floats(0);
    start.sheet = hits.two_sided & (material.refraction_index == Floats(1));
  }
  return start;
}

// A solid that lies on the one that rays leave, without a gap.
struct SolidBehind {
  Mask touches;
  Ints place;
  Floats transmission, refraction_index;
};

// Looks for such a solid where the `leaving` rays go straight on.
inline SolidBehind solid_behind(const Frame& frame, const Rays& rays, const Hits& hits, const RayStart& start,
                                Mask leaving) {
  Rays probe;
  probe.time = rays.time;
  probe.given_up = rays.given_up;
  probe.direction = rays.direction;
  probe.leave(start, Mask(true));
  const Hits behind = intersect(frame.world, probe, -start.nearest, leaving);
  if (none(behind.found)) return {Mask(false), Ints(0u), Floats(0), Floats(1)};
  const Material material = material_at(frame, behind);
  const Floats cosine = dot(behind.normal, rays.direction);
  const Floats gap = (behind.distance - start.back) * abs(cosine);
  const Mask touches = behind.found & (cosine < Floats(0)) & (material.transmission != Floats(0)) &
                       (abs(dot(behind.normal, hits.normal)) > Floats(parallel_cosine)) &
                       (abs(gap) <= (error_at(start) + behind.slack) * Floats(4));
  if (none(touches)) return {touches, Ints(0u), Floats(0), Floats(1)};
  return {touches, behind.place, material.transmission, material.refraction_index};
}

}  // namespace penumbra::PENUMBRA_KERNEL
