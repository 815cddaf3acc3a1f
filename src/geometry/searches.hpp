// The two searches that walk a group, for the nearest hit and for any: what they do with a leaf, be it a shape, a mesh
// or an instance of another group, and which nodes they still want.
#pragma once

#include "geometry/mesh_packet.hpp"
#include "geometry/ray_ends.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Distances are compared with the bounds after widening by this share.
inline constexpr float distance_margin = 1.0f + 1.0f / (1 << 20);

void find_nearest(const World& world, std::uint32_t group, const Rays& rays, Mask active, Hits& hits);
Mask occluded_group(const World& world, std::uint32_t group, const Rays& rays, Floats farthest, Mask active);

// The rays in the space of an instance. Directions are not normalised, so that distances stay what they are.
PENUMBRA_INLINE Rays rays_inside(const World& world, const Leaf& leaf, const Rays& rays) {
  Rays inside = rays;
  inside.origin = local_origin(world, leaf, rays);
  inside.direction = local_direction(world, leaf, rays);
  if (leaf.placement == no_placement) return inside;
  inside.unit = rays.unit && leaf.kind == LeafKind::mesh;  // whose placement is a shift
  inside.first_place += leaf.place;
  inside.outer = &rays;
  inside.instance = &leaf;
  return inside;
}

// Instances and meshes answer for themselves: the lanes they improve are filled in.
inline void intersect_nested(const GroupRays& g, const Leaf& leaf, Mask active, Hits& hits) {
  const Rays inside = rays_inside(g.world, leaf, g.rays);
  if (leaf.kind == LeafKind::mesh) {
    const Mask improved = intersect_mesh(g.world, leaf, inside, active, hits);
    Float3 point = hits.point;
    if (leaf.placement != no_placement) point = point + broadcast3(g.world.placements[leaf.placement].translation);
    if (leaf.moves) point = point + broadcast3(leaf.motion) * g.rays.time;
    hits.point = select(improved, point, hits.point);
    return;
  }
  // Inside, ties are lost to what was named before this instance and won against what was named after it.
  Hits nested(hits.distance);
  const Ints order(leaf.order & order_mask);
  const Ints rank = hits.order & Ints(~order_mask);
  nested.order = select(order < (hits.order & Ints(order_mask)), rank + Ints(order_mask), rank);
  find_nearest(g.world, leaf.target, inside, active, nested);
  if (none(nested.found)) return;
  const Placement& placement = g.world.placements[leaf.placement];
  nested.order = order + (nested.order & Ints(~order_mask));
  nested.point = multiply(placement.linear, nested.point) + broadcast3(placement.translation);
  if (leaf.moves) nested.point = nested.point + broadcast3(leaf.motion) * g.rays.time;
  nested.normal = normalize_any_length(multiply_transposed(placement.inverse, nested.normal));
  nested.slack = max(Floats(leaf.slack), nested.slack * Floats(placement.stretch));
  if (any(nested.smooth)) {
    nested.smooth_normal = normalize(multiply_transposed(placement.inverse, nested.smooth_normal));
    nested.lift = multiply(placement.linear, nested.lift);
  }
  hits.take(nested.found, nested);
}

// The state of a search for the nearest hit in one group: how far it is, and which leaf each lane has, until hits are
// filled in at the end.
struct NearestSearch {
  Hits& hits;  // filled in by nested leaves on the way
  Floats distance;
  Ints order;
  Mask found{false};
  Ints leaf{no_leaf};  // index into World::leaves; none where a nested leaf filled in the hit itself
  Floats cull_distance;

  PENUMBRA_INLINE explicit NearestSearch(Hits& h)
      : hits(h), distance(h.distance), order(h.order), cull_distance(h.distance * Floats(distance_margin)) {}

  PENUMBRA_INLINE void visit(const GroupRays& g, std::uint32_t index, Mask active) {
    const Leaf& candidate = g.world.leaves[index];
    if (candidate.is_nested()) {
      if (g.rays.are_given_up()) return;
      hits.distance = distance;
      hits.order = order;
      intersect_nested(g, candidate, active, hits);
      const Mask changed = ~((distance == hits.distance) & (order == hits.order));
      distance = hits.distance;
      order = hits.order;
      leaf = select(changed, Ints(no_leaf), leaf);
      found |= changed;
    } else {
      const Crossing crossing = wanted_crossing(g, candidate, active, *this);
      const Mask nearer = crossing.hit;
      if (none(nearer)) return;
      distance = select(nearer, crossing.distance, distance);
      order = select(nearer, order_of(candidate, crossing), order);
      leaf = select(nearer, Ints(index), leaf);
      found |= nearer;
    }
    cull_distance = distance * Floats(distance_margin);
  }
  // Where a leaf that is crossed like this is the nearest; where one at this distance may be.
  PENUMBRA_INLINE Mask wants(const Crossing& c, const Leaf& candidate) const {
    return (c.distance < distance) | ((c.distance == distance) & (order_of(candidate, c) < order));
  }
  PENUMBRA_INLINE Mask may_want(Floats t) const { return t <= distance; }
  PENUMBRA_INLINE static Ints order_of(const Leaf& candidate, const Crossing& crossing) {
    const Ints order(candidate.order);
    return candidate.passage == Passage::solid ? select(crossing.leaving, order & Ints(order_mask), order) : order;
  }
  PENUMBRA_INLINE static bool settles(const Rays& rays) { return rays.settle_ends; }
  PENUMBRA_INLINE bool done(Mask) const { return false; }
  PENUMBRA_INLINE Mask still_wanted(Mask active, Floats enter) const { return active & (enter <= cull_distance); }
};

// The state of a search for any hit: which lanes are blocked already.
struct AnySearch {
  Floats farthest;
  Floats cull_distance;
  Mask blocked{false};

  PENUMBRA_INLINE explicit AnySearch(Floats f) : farthest(f), cull_distance(f * Floats(distance_margin)) {}

  PENUMBRA_INLINE void visit(const GroupRays& g, std::uint32_t index, Mask active) {
    const Leaf& candidate = g.world.leaves[index];
    active = active & ~blocked;
    if (candidate.is_nested() && g.rays.are_given_up()) return;
    if (candidate.kind == LeafKind::mesh) {
      blocked |= occluded_mesh(g.world, candidate, rays_inside(g.world, candidate, g.rays), farthest, active);
    } else if (candidate.kind == LeafKind::instance) {
      blocked |= occluded_group(g.world, candidate.target, rays_inside(g.world, candidate, g.rays), farthest, active);
    } else {
      blocked |= wanted_crossing(g, candidate, active, *this).hit;
    }
  }
  PENUMBRA_INLINE Mask wants(const Crossing& c, const Leaf&) const { return c.distance < farthest; }
  PENUMBRA_INLINE Mask may_want(Floats t) const { return t < farthest; }
  PENUMBRA_INLINE static bool settles(const Rays& rays) { return rays.start != nullptr; }
  PENUMBRA_INLINE bool done(Mask all) const { return none(all & ~blocked); }
  PENUMBRA_INLINE Mask still_wanted(Mask active, Floats) const { return active & ~blocked; }
};

}  // namespace penumbra::PENUMBRA_KERNEL
