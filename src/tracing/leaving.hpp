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

// Where rays leave their hits on the side they came from, where that is `behind` the surface.
PENUMBRA_INLINE RayStart start_at(const Hits& hits, const Rays& arrived, const Material& material, Mask behind,
                                  Floats scale) {
  RayStart start;
  alignas(64) std::uint32_t places[lane_count];
  store(places, hits.place);
  start.place = hits.place;
  start.the_place = places[__builtin_ctz(bits(hits.found))];
  start.one_place = none(hits.found & ~(hits.place == Ints(start.the_place)));
  start.previous = arrived.start ? arrived.start->place : Ints(0xffffffffu);
  start.normal = &hits.normal;
  start.incoming = &arrived.direction;
  // Of a large shape, other surfaces know only what is near.
  const Floats rounding = scale * Floats(rounding_share);
  start.back = rounding + min(hits.slack, rounding);
  start.error = rounding + min(hits.slack, rounding * Floats(4));
  start.inward = behind;
  start.through = start.sheet = Mask(false);
  start.opaque = Mask(true);
  if (material.any_transmission) {
    start.opaque = material.transmission == Floats(0);
    start.sheet = hits.two_sided & (material.refraction_index == Floats(1));
  }
  return start;
}

// The same, for rays that leave on the other side in some lanes.
PENUMBRA_INLINE RayStart start_through(const RayStart& start, Mask through) {
  RayStart other = start;
  other.through = through;
  other.inward = (start.inward & ~through) | (through & ~start.inward);
  return other;
}

// A solid that lies on the one that rays leave, without a gap.
struct SolidBehind {
  Mask touches;
  Ints place;
  Floats transmission, refraction_index;
};

// Looks for such a solid where the `leaving` rays go straight on.
inline SolidBehind solid_behind(const Frame& frame, const Rays& rays, const Hits& hits, const RayStart& start,
                                Floats scale, Mask leaving) {
  const RayStart through = start_through(start, Mask(true));
  Rays probe;
  probe.time = rays.time;
  probe.direction = rays.direction;
  probe.leave(through, hits.point, scale);
  const Hits behind = intersect(frame.world, probe, scale * Floats(start_share), leaving);
  if (none(behind.found)) return {Mask(false), Ints(0u), Floats(0), Floats(1)};
  const Material material = material_at(frame, behind);
  const Floats cosine = dot(behind.normal, rays.direction);
  const Floats gap = (behind.distance - start.back) * abs(cosine);
  const Mask touches = behind.found & (cosine < Floats(0)) & (material.transmission != Floats(0)) &
                       (abs(dot(behind.normal, hits.normal)) > Floats(parallel_cosine)) &
                       (abs(gap) <= (start.error + behind.slack) * Floats(4));
  if (none(touches)) return {touches, Ints(0u), Floats(0), Floats(1)};
  return {touches, behind.place, material.transmission, material.refraction_index};
}

}  // namespace penumbra::PENUMBRA_KERNEL
