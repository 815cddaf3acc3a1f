// Packets of rays against one leaf, with what touches the ends of the rays: the surface they start on does not count,
// other surfaces there count if they are still ahead (geometry/ray_start.hpp), and a shadow ray ends before the
// surfaces that its light lies in.
#pragma once

#include "geometry/leaf_packet.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// What is asked of a leaf that rays may start on: a flat surface they do not meet again, a curved one only where they
// come out of it.
PENUMBRA_INLINE Wanted wanted_from_start(const GroupRays& g, const Leaf& leaf, Mask active) {
  const Mask own = *g.rays.start->place == Ints(g.place_of(leaf));
  const Mask inside = leaf.kind == LeafKind::triangle ? Mask(false) : own & g.rays.inward();
  return {active & (~own | inside), inside, g.rays.nearest};
}

template <typename Search>
__attribute__((noinline)) inline Crossing cross_from_start(const GroupRays& g, const Leaf& leaf, Mask active,
                                                           const Search& search) {
  const Wanted wanted = wanted_from_start(g, leaf, active);
  if (none(wanted.active)) return {Mask(false), Floats(0), Mask(false)};
  Crossing crossing = cross_leaf(g, leaf, wanted, search);
  crossing.hit = crossing.hit & wanted.active;
  return crossing;
}

// Decides about crossings near the ends of the rays. Where one does not count, the next of the leaf may.
template <typename Search>
__attribute__((noinline)) inline Crossing settle_ends(const GroupRays& g, const Leaf& leaf, Mask active, Search search,
                                                      Crossing crossing) {
  const StartHere start = start_here(g.world, g.rays);
  const Float3 direction = g.rays.direction;
  const RayStart* before = g.rays.start->arrived->start;
  const Ints previous = before ? *before->place : Ints(no_place);
  Wanted wanted = wanted_from_start(g, leaf, active);
  while (true) {
    const Floats t = crossing.distance;
    const Mask near_start = crossing.hit & ~wanted.inside & g.rays.near_start(t);
    const Mask near_light = crossing.hit & g.rays.near_light(t);
    if (none(near_start | near_light)) return crossing;
    const Float3 normal = surface_of(g, leaf, t).normal;
    const Floats error = start.error + min(Floats(leaf.slack), start.error);
    const Mask passed = near_start & ~still_ahead(*g.rays.start, previous, g.rays.through, start, direction,
                                                  {Ints(g.place_of(leaf)), leaf.passage, normal, t, error});
    if (any(near_light)) {
      const Floats height = (g.rays.light_distance - t) * abs(dot(normal, direction));
      const Floats length = g.rays.light_distance * sqrt(dot(direction, direction));
      crossing.hit = crossing.hit & ~(near_light & (height <= error + length * Floats(rounding_share)));
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

// Where the rays cross a leaf as the search wants it. What is rare is called; its results are taken one by one, because
// to copy a Crossing whole that was only just written piece by piece makes the processor wait.
template <typename Search>
PENUMBRA_INLINE Crossing wanted_crossing(const GroupRays& g, const Leaf& leaf, Mask active, const Search& search) {
  Mask hit(false), leaving(false);
  Floats distance = Floats(0);
  const auto take = [&](const Crossing& c) {
    hit = c.hit;
    distance = c.distance;
    leaving = c.leaving;
  };
  const bool may_enter = g.rays.any_inward && leaf.kind != LeafKind::triangle;
  bool any_enter = false;
  if (g.all_start_on(leaf)) {
    if (!may_enter) return {hit, distance, leaving};
    any_enter = true;
  } else if (g.many_places()) {
    const Mask own = active & (*g.rays.start->place == Ints(g.place_of(leaf)));
    if (may_enter) {
      any_enter = any(own);
    } else {
      active = active & ~own;
    }
  }
  if (any_enter) {
    take(cross_from_start(g, leaf, active, search));
  } else {
    take(cross_leaf(g, leaf, {active, Mask(false), g.rays.nearest}, search));
  }
  hit = hit & active & search.wants({hit, distance, leaving}, leaf);
  if (search.settles(g.rays) && any(hit) && any(hit & (g.rays.near_start(distance) | g.rays.near_light(distance)))) {
    take(settle_ends(g, leaf, active, search, {hit, distance, leaving}));
  }
  return {hit, distance, leaving};
}

}  // namespace penumbra::PENUMBRA_KERNEL
