// Packets of rays against one leaf, with what touches the ends of the rays: the surface they start on does not count,
// other surfaces there count if they are still ahead (geometry/ray_start.hpp), and a shadow ray ends before the
// surfaces that its light lies in.
#pragma once

#include "geometry/leaf_packet.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Decides about crossings near the ends of the rays. Where one does not count, the next of the leaf may.
template <typename Search>
__attribute__((noinline)) inline Crossing settle_ends(const GroupRays& g, std::uint32_t index, Wanted wanted,
                                                      Search search, Crossing crossing) {
  const Leaf& leaf = g.world.leaves[index];
  const StartHere start = start_here(g.world, g.rays);
  const Float3 direction = g.rays.direction;
  while (true) {
    const Floats t = crossing.distance;
    const Mask near_start = crossing.hit & ~wanted.inside & (t < -g.rays.nearest);
    const Mask near_end = crossing.hit & Mask(g.rays.to_light) & (t > g.rays.light_distance * Floats(1 - light_share));
    if (none(near_start | near_end)) return crossing;
    const Float3 normal = surface_of(g, leaf, t).normal;
    const Floats error = start.error + min(Floats(leaf.slack), start.error);
    const Mask passed = near_start & ~still_ahead(*g.rays.start, start, direction,
                                                  {Ints(g.rays.first_place + index), leaf.passage, normal, t, error});
    if (any(near_end)) {
      const Floats height = (g.rays.light_distance - t) * abs(dot(normal, direction));
      const Floats length = g.rays.light_distance * sqrt(dot(direction, direction));
      crossing.hit = crossing.hit & ~(near_end & (height <= error + length * Floats(rounding_share)));
    }
    const Mask open = crossing.hit & passed;
    crossing.hit = crossing.hit & ~passed;
    if (none(open)) return crossing;
    wanted.active = open;
    wanted.nearest = select(open, t, wanted.nearest);
    const Crossing next = cross_leaf(g, leaf, wanted, search);
    crossing.hit |= open & next.hit & search.wants(next, leaf);
    crossing.distance = select(open, next.distance, t);
    crossing.leaving = (open & next.leaving) | (~open & crossing.leaving);
  }
}

// Where the rays cross leaf `index` as the search wants it.
template <typename Search>
PENUMBRA_INLINE Crossing cross_from_start(const GroupRays& g, std::uint32_t index, Mask active, const Search& search) {
  const Leaf& leaf = g.world.leaves[index];
  Wanted wanted{active, Mask(false), g.rays.nearest};
  const std::uint32_t place = g.rays.first_place + index;
  if (g.rays.start && g.rays.start->any_at(place, active)) {
    const Mask own = g.rays.start->place == Ints(place);
    if (leaf.kind != LeafKind::triangle) wanted.inside = own & g.rays.start->inward;  // a plane is not crossed twice
    wanted.active = active & (~own | wanted.inside);
    if (none(wanted.active)) return {Mask(false), Floats(0), Mask(false)};
  }
  Crossing crossing = cross_leaf(g, leaf, wanted, search);
  crossing.hit = crossing.hit & wanted.active & search.wants(crossing, leaf);
  if (g.rays.start && any(crossing.hit)) {
    const Mask near_start = crossing.hit & (crossing.distance < -g.rays.nearest);
    const bool may_hold_light =
        g.rays.to_light && any(crossing.distance > g.rays.light_distance * Floats(1 - light_share));
    if (any(near_start) || may_hold_light) return settle_ends(g, index, wanted, search, crossing);
  }
  return crossing;
}

}  // namespace penumbra::PENUMBRA_KERNEL
