// A packet of rays, and what the world answers about it.
#pragma once

#include <atomic>

#include "base/lane_math.hpp"
#include "geometry/ray_start.hpp"
#include "geometry/smooth_triangle.hpp"
#include "geometry/world.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Rays {
  Float3 origin;
  Float3 direction;       // unit length in the world; any length behind a placement
  Floats time;            // of the shutter
  Floats nearest{0.0f};   // hits at this distance or nearer do not count
  bool unit = true;       // the directions have length one
  bool coherent = false;  // the rays run close together: a hint for Embree
  // Where the rays leave a surface; eye rays have no such start. Surfaces that touch the start are met from -nearest
  // down to `nearest`.
  const RayStart* start = nullptr;
  Mask through{false};  // they leave it to the side that the rays that arrived did not come from
  bool any_inward = false;
  // A shadow ray ends before the surfaces that its light lies in.
  bool to_light = false;
  Floats light_distance;
  const std::atomic<bool>* given_up = nullptr;  // once it is set, searches may end early, with any result
  bool settle_ends = false;                     // the search for the nearest hit decides about crossings near the ends
  // Inside of an instance: the rays outside of it, its leaf, and the place (Hits::place) of leaf 0.
  const Rays* outer = nullptr;
  const Leaf* instance = nullptr;
  std::uint32_t first_place = 0;

  // Lets the rays start on a surface, and leave it where they came from or `through` it.
  PENUMBRA_INLINE void leave(const RayStart& from, Mask goes_through) {
    start = &from;
    through = goes_through;
    any_inward = any(inward());
    origin = from.origin;
    nearest = from.nearest;
  }
  // Where a crossing is so near to an end of the rays that it may not count (geometry/ray_ends.hpp).
  PENUMBRA_INLINE Mask near_start(Floats distance) const { return distance < -nearest; }
  PENUMBRA_INLINE Mask near_light(Floats distance) const {
    return Mask(to_light) & (distance > light_distance * Floats(1 - light_share));
  }
  PENUMBRA_INLINE bool are_given_up() const { return given_up && given_up->load(std::memory_order_relaxed); }
  // Which of them leave it to the side that its normal points away from.
  PENUMBRA_INLINE Mask inward() const { return leaves_inward(*start, through); }
};

// What the rays hit first. The lanes in `found` are filled in; points and normals are in the space of the rays.
struct Hits {
  Floats distance;  // along the direction; in: the farthest that counts (exclusive), out: of the hit
  Ints order;       // of the leaf that was hit, for ties, with its TouchRank
  Mask found;
  Float3 point;   // put back on the exact surface
  Float3 normal;  // outward, unit length in the world
  Ints surface;
  Mask two_sided;          // a triangle: shading turns its normal to the viewer
  Float3 texture_point;    // in the space where the shape was defined; where the world has textures
  Mask smooth;             // a triangle whose corners have normals; where the world has such
  Float3 smooth_normal;    // there, for the side that the ray comes from: of unit length in the world
  Float3 lift;             // and from the point to where shadow rays start (geometry/smooth_triangle.hpp)
  Ints place;              // of the leaf among all leaves of all instances
  bool defined = false;    // all of this, also in lanes that hit nothing
  bool one_place = false;  // in all lanes that hit: this one
  std::uint32_t the_place;
  Floats slack;  // Leaf::slack

  PENUMBRA_INLINE explicit Hits(Floats farthest) : distance(farthest), order(0u), found(false), smooth(false) {}

  // For lanes that hit a triangle whose corners have normals.
  PENUMBRA_INLINE void set_smooth(Mask lanes, const SmoothPoint& at) {
    smooth |= lanes;
    smooth_normal = select(lanes, at.normal, smooth_normal);
    lift = select(lanes, at.lift, lift);
  }

  // Replaces the lanes by those of other hits.
  PENUMBRA_INLINE void take(Mask lanes, const Hits& other) {
    define();
    distance = select(lanes, other.distance, distance);
    order = select(lanes, other.order, order);
    point = select(lanes, other.point, point);
    normal = select(lanes, other.normal, normal);
    surface = select(lanes, other.surface, surface);
    two_sided = (two_sided & ~lanes) | (other.two_sided & lanes);
    texture_point = select(lanes, other.texture_point, texture_point);
    place = select(lanes, other.place, place);
    one_place = other.one_place && none(found & ~lanes);
    the_place = other.the_place;
    slack = select(lanes, other.slack, slack);
    smooth = smooth & ~lanes;
    if (any(lanes & other.smooth)) set_smooth(lanes & other.smooth, {other.smooth_normal, other.lift});
    found = (found & ~lanes) | (other.found & lanes);
  }

  // Lanes can be filled in afterwards.
  PENUMBRA_INLINE void define() {
    if (defined) return;
    defined = true;
    const Float3 zero{0.0f, 0.0f, 0.0f};
    point = normal = texture_point = smooth_normal = lift = zero;
    surface = Ints(0u);
    place = Ints(0u);
    slack = Floats(0);
    two_sided = Mask(false);
  }
};

PENUMBRA_INLINE Float3 multiply(const float* rows, Float3 v) {
  return {v.x * Floats(rows[0]) + v.y * Floats(rows[1]) + v.z * Floats(rows[2]),
          v.x * Floats(rows[3]) + v.y * Floats(rows[4]) + v.z * Floats(rows[5]),
          v.x * Floats(rows[6]) + v.y * Floats(rows[7]) + v.z * Floats(rows[8])};
}
PENUMBRA_INLINE Float3 multiply_transposed(const float* rows, Float3 v) {
  return {v.x * Floats(rows[0]) + v.y * Floats(rows[3]) + v.z * Floats(rows[6]),
          v.x * Floats(rows[1]) + v.y * Floats(rows[4]) + v.z * Floats(rows[7]),
          v.x * Floats(rows[2]) + v.y * Floats(rows[5]) + v.z * Floats(rows[8])};
}

// How far the hit point of a start may be off.
inline Floats error_at(const RayStart& start) {
  const Floats rounding = start.nearest * Floats(-rounding_share / start_share);
  return rounding + min(start.hits->slack, rounding * Floats(4));
}

// The start of rays, in their own space.
inline StartHere start_here(const World& world, const Rays& rays) {
  if (!rays.outer) return {rays.start->hits->normal, rays.start->arrived->direction, error_at(*rays.start)};
  const StartHere outside = start_here(world, *rays.outer);
  const Placement& placement = world.placements[rays.instance->placement];
  return {normalize(multiply_transposed(placement.linear, outside.normal)),
          multiply(placement.inverse, outside.incoming),
          (outside.error + Floats(rays.instance->slack)) * Floats(placement.shrink)};
}

// The rays as the leaf sees them: its motion undone at each ray's time, then its placement.
PENUMBRA_INLINE Float3 local_origin(const World& world, const Leaf& leaf, const Rays& rays) {
  Float3 origin = rays.origin;
  if (leaf.moves) origin = origin - broadcast3(leaf.motion) * rays.time;
  if (leaf.placement == no_placement) return origin;
  const Placement& placement = world.placements[leaf.placement];
  return multiply(placement.inverse, origin - broadcast3(placement.translation));
}
PENUMBRA_INLINE Float3 local_direction(const World& world, const Leaf& leaf, const Rays& rays) {
  if (leaf.placement == no_placement) return rays.direction;
  return multiply(world.placements[leaf.placement].inverse, rays.direction);
}

}  // namespace penumbra::PENUMBRA_KERNEL
