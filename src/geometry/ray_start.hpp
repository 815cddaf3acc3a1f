// Where rays leave a surface, and what they meet there. The surface itself they do not meet again: it is known by name,
// not by a distance. They start as far before it, along the rays that arrived, as the hit point may be off: at an edge,
// on the right side of both surfaces. Whether another surface that touches the start is still ahead, no distance tells:
//
//   - Surfaces that lie on each other are crossed one after the other, in the order of their TouchRank.
//   - A surface that the start's surface meets in an edge counts from distance 0 on. Rounding may have put the start
//     beyond it; then it is ahead if it lies in front of the start's surface, and the rays that leave go through it the
//     same way as those that arrived, or, if those had started on it, the other way.
#pragma once

#include "base/lane_math.hpp"
#include "geometry/leaf.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// A computed point is off by no more than this share of its largest coordinate.
inline constexpr float rounding_share = 1.0f / (1 << 20);
// A surface that touches the start of a ray is crossed within this share of the ray's scale, one that holds its light
// within this share of the distance to it, unless the ray grazes the surface.
inline constexpr float start_share = 1.0f / (1 << 12);
inline constexpr float light_share = 1.0f / (1 << 8);
// Surfaces whose normals have at least this cosine lie on each other.
inline constexpr float parallel_cosine = 0.9999f;

struct Rays;
struct Hits;

// A surface that rays arrived at, for all rays that leave it.
struct RayStart {
  const Rays* arrived;
  const Hits* hits;
  const Ints* place;  // as in Hits, unless the rays have gone on into the next solid
  bool one_place;
  std::uint32_t the_place;
  Float3 origin;       // of the rays that leave
  Floats back;         // the distance along those that arrived from the origin to the hit point
  Floats nearest;      // Rays::nearest of the rays that leave
  Mask behind;         // the rays arrived at the side that the normal points away from
  Mask opaque, sheet;  // what the surface is
};

// What depends on the space that the rays are seen in.
struct StartHere {
  Float3 normal, incoming;  // outward, and of the rays that arrived, of any length
  Floats error;             // how far the hit point may be off
};

PENUMBRA_INLINE Ints touch_rank(Passage passage, Mask leaving) {
  if (passage != Passage::solid) return Ints(passage == Passage::sheet ? touch_sheet : touch_opaque);
  return select(leaving, Ints(touch_out), Ints(touch_into));
}

// A crossing near the start: what surface, with its outward normals and how far off it may be.
struct CrossingNearStart {
  Ints place;
  Passage passage;
  Float3 normal;
  Floats distance, error;
};

// Which rays leave to the side that the normal points away from, where those that go `through` the surface leave to the
// side that they did not come from.
PENUMBRA_INLINE Mask leaves_inward(const RayStart& start, Mask through) {
  return (start.behind & ~through) | (through & ~start.behind);
}

// The rank up to which surfaces that lie on the start's are behind the rays.
PENUMBRA_INLINE Ints rank_passed(const RayStart& start, Mask through) {
  const Ints of_solid = select(leaves_inward(start, through), Ints(touch_into), Ints(touch_out));
  const Ints of_sheet = select(through, Ints(touch_sheet), Ints(touch_opaque));
  return select(start.opaque, Ints(touch_opaque), select(start.sheet, of_sheet, of_solid));
}

// Which rays still have the crossing ahead; `previous` is the place that the rays that arrived had started on.
PENUMBRA_INLINE Mask still_ahead(const RayStart& start, Ints previous, Mask through, const StartHere& here,
                                 Float3 direction, const CrossingNearStart& crossing) {
  const Floats zero = Floats(0);
  const Float3 normal = crossing.normal;
  const Floats out = dot(normal, direction);
  const Floats height = crossing.distance * abs(out);
  const Mask parallel = abs(dot(normal, here.normal)) > Floats(parallel_cosine);
  const Mask lies_on = parallel & (abs(height) <= crossing.error * Floats(4));
  Mask later = rank_passed(start, through) < touch_rank(crossing.passage, out > zero);
  if (crossing.passage == Passage::sheet) later |= start.opaque;

  const Mask beyond = crossing.distance > zero;
  const Mask came_from_it = crossing.place == previous;
  const Mask same_way = out * dot(normal, here.incoming) > zero;
  const Floats arriving = dot(here.normal, here.incoming);
  const Floats rise = dot(here.normal, direction) * crossing.distance;
  const Floats in_front = copysign(Floats(1), arriving) * (arriving * start.back - rise);
  const Mask rounded = (height >= -crossing.error) & (in_front > crossing.error * Floats(1.0f / 16)) &
                       ((same_way & ~came_from_it) | (~same_way & came_from_it));
  return (lies_on & later) | (~lies_on & (beyond | (~parallel & rounded)));
}

}  // namespace penumbra::PENUMBRA_KERNEL
