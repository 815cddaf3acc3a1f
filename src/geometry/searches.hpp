// The two searches that walk a group, for the nearest hit and for any: what they do with a leaf, be it a shape, a mesh
// or an instance of another group, and which nodes they still want.
#pragma once

#include "geometry/leaf_packet.hpp"
#include "geometry/mesh_packet.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Distances are compared with the bounds after widening by this share.
inline constexpr float distance_margin = 1.0f + 1.0f / (1 << 20);

void intersect_group(const World& world, std::uint32_t group, const Rays& rays, Mask active, Hits& hits);
Mask occluded_group(const World& world, std::uint32_t group, const Rays& rays, Floats farthest, Mask active);

// The rays in the space of an instance. Directions are not normalised, so that distances stay what they are.
PENUMBRA_INLINE Rays rays_inside(const World& world, const Leaf& leaf, const Rays& rays) {
  Rays inside = rays;
  inside.origin = local_origin(world, leaf, rays);
  inside.direction = local_direction(world, leaf, rays);
  inside.unit = rays.unit && leaf.placement == no_placement;
  return inside;
}

// Instances and meshes answer for themselves: the lanes they improve are filled in.
inline void intersect_nested(const GroupRays& g, const Leaf& leaf, Mask active, Hits& hits) {
  const Rays inside = rays_inside(g.world, leaf, g.rays);
  if (leaf.kind == LeafKind::mesh) {
    const Mask improved = intersect_mesh(g.world, leaf, inside, active, hits);
    if (leaf.moves) {
      hits.point = select(improved, hits.point + broadcast3(leaf.motion) * g.rays.time, hits.point);
    }
    return;
  }
  // Inside, ties are lost to what was named before this instance and won against what was named after it.
  Hits nested = hits;
  nested.order = select(Ints(leaf.order) < hits.order, Ints(0xffffffffu), Ints(0u));
  nested.found = Mask(false);
  intersect_group(g.world, leaf.target, inside, active, nested);
  const Mask improved = nested.found;
  if (none(improved)) return;
  const Placement& placement = g.world.placements[leaf.placement];
  Float3 point = multiply(placement.linear, nested.point) + broadcast3(placement.translation);
  if (leaf.moves) point = point + broadcast3(leaf.motion) * g.rays.time;
  const Float3 normal = normalize_any_length(multiply_transposed(placement.inverse, nested.normal));
  const Floats reach = max(Floats(leaf.magnitude), nested.magnitude * Floats(placement.stretch));
  hits.distance = select(improved, nested.distance, hits.distance);
  hits.order = select(improved, Ints(leaf.order), hits.order);
  hits.point = select(improved, point, hits.point);
  hits.normal = select(improved, normal, hits.normal);
  hits.surface = select(improved, nested.surface, hits.surface);
  hits.two_sided = (hits.two_sided & ~improved) | (nested.two_sided & improved);
  hits.texture_point = select(improved, nested.texture_point, hits.texture_point);
  hits.magnitude = select(improved, reach, hits.magnitude);
  hits.found |= improved;
}

// The state of a search for the nearest hit in one group: how far it is, and which leaf each lane has, until hits are
// filled in at the end.
struct NearestSearch {
  static constexpr std::uint32_t no_leaf = 0xffffffffu;
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
      hits.distance = distance;
      hits.order = order;
      intersect_nested(g, candidate, active, hits);
      const Mask changed = ~((distance == hits.distance) & (order == hits.order));
      distance = hits.distance;
      order = hits.order;
      leaf = select(changed, Ints(no_leaf), leaf);
      found |= changed;
    } else {
      const Crossing crossing = cross_leaf(g, candidate, active, *this);
      const Mask nearer = active & crossing.hit & wants(crossing.distance, candidate);
      if (none(nearer)) return;
      distance = select(nearer, crossing.distance, distance);
      order = select(nearer, Ints(candidate.order), order);
      leaf = select(nearer, Ints(index), leaf);
      found |= nearer;
    }
    cull_distance = distance * Floats(distance_margin);
  }
  // Where a leaf at this distance would be the nearest.
  PENUMBRA_INLINE Mask wants(Floats t, const Leaf& candidate) const {
    return (t < distance) | ((t == distance) & (Ints(candidate.order) < order));
  }
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
    if (candidate.kind == LeafKind::mesh) {
      blocked |= occluded_mesh(g.world, candidate, rays_inside(g.world, candidate, g.rays), farthest, active);
    } else if (candidate.kind == LeafKind::instance) {
      blocked |= occluded_group(g.world, candidate.target, rays_inside(g.world, candidate, g.rays), farthest, active);
    } else {
      const Crossing crossing = cross_leaf(g, candidate, active, *this);
      blocked |= active & crossing.hit & wants(crossing.distance, candidate);
    }
  }
  PENUMBRA_INLINE Mask wants(Floats t, const Leaf&) const { return t < farthest; }
  PENUMBRA_INLINE bool done(Mask all) const { return none(all & ~blocked); }
  PENUMBRA_INLINE Mask still_wanted(Mask active, Floats) const { return active & ~blocked; }
};

}  // namespace penumbra::PENUMBRA_KERNEL
