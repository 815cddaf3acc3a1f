// The two questions to the world, for W rays at a time: what do they hit first (intersect), and is anything in their
// way (occluded). Plain packet traversal of a binary BVH: every node is fetched once and tested against all rays, the
// lanes that miss it are masked out (Wald et al. 2001). What a lane answers does not depend on the other lanes of its
// packet: bounds are wide enough that no node is left out behind which an equal or nearer hit could be.
#pragma once

#include "geometry/searches.hpp"

namespace penumbra::PENUMBRA_KERNEL {

inline constexpr int traversal_stack_size = 64;

template <bool agreed, typename Search>
PENUMBRA_INLINE void traverse_nodes(const GroupRays& g, NodeReference root, Mask active, Search& search) {
  struct Waiting {
    Floats enter;
    Mask active;
    NodeReference node;
  };
  Waiting stack[traversal_stack_size];
  int waiting = 0;
  NodeReference current = root;
  Mask lanes = active;
  while (true) {
    if (is_leaf(current)) {
      const std::uint32_t first = leaf_first(current);
      for (std::uint32_t i = 0; i < leaf_count(current); i++) search.visit(g, first + i, lanes);
      if (search.done(active)) return;
    } else {
      const Node& node = g.world.nodes[current];
      const Interval a = g.inside<agreed>(node.bounds[0]);
      const Interval b = g.inside<agreed>(node.bounds[1]);
      const Floats margin = Floats(distance_margin);
      const Floats zero = Floats(0);
      const Floats leave_a = min(a.leave * margin, search.cull_distance);
      const Floats leave_b = min(b.leave * margin, search.cull_distance);
      const Mask wanted = search.still_wanted(lanes, zero);
      const Mask in_a = wanted & (max(a.enter, zero) <= leave_a);
      const Mask in_b = wanted & (max(b.enter, zero) <= leave_b);
      const bool any_a = any(in_a);
      const bool any_b = any(in_b);
      if (any_a && any_b) {
        const Mask both = in_a & in_b;
        const bool a_first = 2 * count(both & (a.enter <= b.enter)) >= count(both);
        // Member by member: to copy whole what was only just written piece by piece makes the processor wait.
        Waiting& later = stack[waiting++];
        if (a_first) {
          later.enter = b.enter;
          later.active = in_b;
          lanes = in_a;
        } else {
          later.enter = a.enter;
          later.active = in_a;
          lanes = in_b;
        }
        later.node = node.child[a_first ? 1 : 0];
        current = node.child[a_first ? 0 : 1];
        continue;
      }
      if (any_a || any_b) {
        current = node.child[any_a ? 0 : 1];
        lanes = any_a ? in_a : in_b;
        continue;
      }
    }
    do {
      if (waiting == 0) return;
      const Waiting& next = stack[--waiting];
      lanes = search.still_wanted(next.active, next.enter);
      current = next.node;
    } while (none(lanes));
  }
}

template <typename Search>
PENUMBRA_INLINE void traverse(const GroupRays& g, NodeReference root, Mask active, Search& search) {
  if (is_leaf(root)) {
    for (std::uint32_t i = 0; i < leaf_count(root); i++) search.visit(g, leaf_first(root) + i, active);
  } else if (g.order.agreed) {
    traverse_nodes<true>(g, root, active, search);
  } else {
    traverse_nodes<false>(g, root, active, search);
  }
}

// Fills in what the rays meet first in a group. Of `hits`, distance and order are defined: what is met must be nearer.
inline void find_nearest(const World& world, std::uint32_t group, const Rays& rays, Mask active, Hits& hits) {
  const GroupRays g(world, world.groups[group], rays, active);
  NearestSearch search(hits);
  traverse(g, world.groups[group].root, active, search);

  hits.distance = search.distance;
  hits.order = search.order;
  hits.found = search.found;
  alignas(64) std::uint32_t leaf_of_lane[lane_count];
  store(leaf_of_lane, search.leaf);
  Mask open = search.found & ~(search.leaf == Ints(no_leaf));
  if (none(open)) return;
  hits.one_place = bits(open) == bits(search.found);
  hits.the_place = g.place_of(world.leaves[leaf_of_lane[__builtin_ctz(bits(open))]]);
  do {
    const std::uint32_t index = leaf_of_lane[__builtin_ctz(bits(open))];
    const Mask same = open & (search.leaf == Ints(index));
    if (!hits.defined && bits(same) == bits(open)) {
      finish_hit<true>(g, index, same, hits);
      hits.defined = true;
      return;
    }
    hits.define();
    finish_hit<false>(g, index, same, hits);
    hits.one_place = hits.one_place && g.place_of(world.leaves[index]) == hits.the_place;
    open = open & ~same;
  } while (any(open));
}

inline Mask occluded_group(const World& world, std::uint32_t group, const Rays& rays, Floats farthest, Mask active) {
  const GroupRays g(world, world.groups[group], rays, active);
  AnySearch search(farthest);
  traverse(g, world.groups[group].root, active, search);
  return search.blocked;
}

// What the rays hit first, nearer than `farthest`. What lies near their ends counts at first; where it was found
// nearest, a second search decides. Few rays need it.
__attribute__((noinline)) inline Hits intersect(const World& world, const Rays& rays, Floats farthest, Mask active) {
  Hits hits(farthest);
  find_nearest(world, 0, rays, active, hits);
  if (none(hits.found)) {
    hits.define();
    return hits;
  }
  if (rays.start && !rays.settle_ends) {
    const Mask near = hits.found & (rays.near_start(hits.distance) | rays.near_light(hits.distance));
    if (any(near)) {
      Rays careful = rays;
      careful.settle_ends = true;
      hits.take(near, intersect(world, careful, farthest, near));
    }
  }
  return hits;
}

// Which of the rays meet anything nearer than `farthest`.
inline Mask occluded(const World& world, const Rays& rays, Floats farthest, Mask active) {
  return occluded_group(world, 0, rays, farthest, active);
}

}  // namespace penumbra::PENUMBRA_KERNEL
