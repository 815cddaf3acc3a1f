// The two questions to the world, for W rays at a time: what do they hit first (intersect), and is anything in their
// way (occluded). Plain packet traversal of a binary BVH: every node is fetched once and tested against all rays, the
// lanes that miss it are masked out (Wald et al. 2001). What a lane answers does not depend on the other lanes of its
// packet: bounds are wide enough that no node is left out behind which an equal or nearer hit could be.
#pragma once

#include "geometry/mesh_packet.hpp"
#include "geometry/rays.hpp"
#include "geometry/shape_kernels.hpp"
#include "geometry/triangle_kernel.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Distances are compared with the bounds after widening by this share.
inline constexpr float distance_margin = 1.0f + 1.0f / (1 << 20);

inline constexpr int traversal_stack_size = 64;

// Which of a node's bounds each axis enters and leaves by, where all rays of a packet agree: it halves the work of a
// slab.
struct SlabOrder {
  bool agreed = true;
  int enter[3], leave[3];

  // In place: to copy what was only just written piece by piece makes the processor wait.
  PENUMBRA_INLINE void find(Float3 inverse_direction, Mask active) {
    const Floats axes[3] = {inverse_direction.x, inverse_direction.y, inverse_direction.z};
    for (int axis = 0; axis < 3; axis++) {
      const Mask forward = active & (axes[axis] > Floats(0));
      const bool any_forward = any(forward);
      agreed = agreed && (!any_forward || bits(forward) == bits(active));
      enter[axis] = any_forward ? axis : 3 + axis;
      leave[axis] = any_forward ? 3 + axis : axis;
    }
  }
};

// What a traversal of one group carries along for its rays. Nothing is prepared that a group of few shapes does not
// need.
struct GroupRays {
  const World& world;
  const Rays& rays;
  Mask active;
  Float3 inverse_direction;
  SlabOrder order;

  PENUMBRA_INLINE GroupRays(const World& w, const WorldGroup& group, const Rays& r, Mask lanes)
      : world(w), rays(r), active(lanes) {
    if (!is_leaf(group.root)) {
      inverse_direction = safe_inverse(r.direction);
      order.find(inverse_direction, active);
    }
  }

  // Computed for the first triangle that may be met.
  PENUMBRA_INLINE const RayShear& shear() const {
    if (!has_shear_) shear_ = RayShear(rays.direction, active);
    has_shear_ = true;
    return shear_;
  }

  // Where the rays are inside the bounds of a node's child.
  template <bool agreed>
  PENUMBRA_INLINE Interval inside(const float* bounds) const {
    if constexpr (!agreed) return cross_slabs(bounds, rays.origin, inverse_direction);
    const Floats enter_x = (Floats(bounds[order.enter[0]]) - rays.origin.x) * inverse_direction.x;
    const Floats enter_y = (Floats(bounds[order.enter[1]]) - rays.origin.y) * inverse_direction.y;
    const Floats enter_z = (Floats(bounds[order.enter[2]]) - rays.origin.z) * inverse_direction.z;
    const Floats leave_x = (Floats(bounds[order.leave[0]]) - rays.origin.x) * inverse_direction.x;
    const Floats leave_y = (Floats(bounds[order.leave[1]]) - rays.origin.y) * inverse_direction.y;
    const Floats leave_z = (Floats(bounds[order.leave[2]]) - rays.origin.z) * inverse_direction.z;
    return {max(max(enter_x, enter_y), enter_z), min(min(leave_x, leave_y), leave_z)};
  }

 private:
  mutable RayShear shear_;
  mutable bool has_shear_ = false;
};

// Where the rays cross the leaf's shape, for the kinds that are one shape. What the search does not want may be left
// out.
template <typename Search>
PENUMBRA_INLINE Crossing cross_shape(const GroupRays& g, const Leaf& leaf, Mask active, const Search& search) {
  const bool placed = leaf.placement != no_placement;
  const Float3 origin = local_origin(g.world, leaf, g.rays);
  if (leaf.kind == LeafKind::triangle) {
    const Float3 corner = broadcast3(leaf.data) - origin;
    const SeenPlane plane(broadcast3(leaf.data + 9), corner, g.rays.direction);
    const auto may_meet = [&](Mask lanes) { return any(lanes) || any(active & plane.grazing(g.rays.direction)); };
    if (!may_meet(active & plane.ahead()) || !may_meet(active & search.wants(plane.distance(), leaf))) {
      return {Mask(false), Floats(0)};
    }
    return cross_triangle({corner, broadcast3(leaf.data + 3) - origin, broadcast3(leaf.data + 6) - origin, plane},
                          g.rays.direction, g.rays.nearest, g.shear());
  }
  const Float3 direction = local_direction(g.world, leaf, g.rays);
  switch (leaf.kind) {
    case LeafKind::sphere:
      return cross_sphere(leaf.data, origin, direction, g.rays.nearest, g.rays.unit && !placed);
    case LeafKind::box:
      return cross_box(leaf.data, origin, direction, g.rays.nearest);
    case LeafKind::cylinder:
      return cross_cylinder(leaf.data, origin, direction, g.rays.nearest, true);
    default:
      return cross_cylinder(leaf.data, origin, direction, g.rays.nearest, false);
  }
}

// Fills in `hits` for the lanes that hit this leaf at `distance`; where `whole`, for all lanes.
template <bool whole>
PENUMBRA_INLINE void finish_hit(const GroupRays& g, const Leaf& leaf, Mask lanes, Hits& hits) {
  const Float3 origin = local_origin(g.world, leaf, g.rays);
  const Float3 direction = local_direction(g.world, leaf, g.rays);
  Float3 point = origin + direction * hits.distance;
  Float3 normal;
  switch (leaf.kind) {
    case LeafKind::sphere:
      sphere_surface(leaf.data, point, normal);
      break;
    case LeafKind::box:
      box_surface(leaf.data, origin, direction, hits.distance, point, normal);
      break;
    case LeafKind::cylinder:
      capped_surface(leaf.data, origin, direction, hits.distance, point, normal);
      break;
    case LeafKind::hollow_cylinder:
      wall_surface(leaf.data, point, normal);
      break;
    default:
      normal = broadcast3(leaf.data + 9);
      point = point - normal * dot(normal, point - broadcast3(leaf.data));
  }
  if (leaf.placement != no_placement) {
    const Placement& placement = g.world.placements[leaf.placement];
    point = multiply(placement.linear, point) + broadcast3(placement.translation);
    normal = normalize(multiply_transposed(placement.inverse, normal));
  }
  const auto set = [&](auto& field, auto value) {
    if constexpr (whole) {
      field = value;
    } else {
      field = select(lanes, value, field);
    }
  };
  if (g.world.has_textures) set(hits.texture_point, point);
  if (leaf.moves) point = point + broadcast3(leaf.motion) * g.rays.time;
  set(hits.point, point);
  set(hits.normal, normal);
  set(hits.surface, Ints(leaf.target));
  set(hits.magnitude, Floats(leaf.magnitude));
  const Mask triangle(leaf.kind == LeafKind::triangle);
  hits.two_sided = whole ? triangle : (hits.two_sided & ~lanes) | (lanes & triangle);
}

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
  const Float3 normal = normalize(multiply_transposed(placement.inverse, nested.normal));
  const Floats reach = max(Floats(leaf.magnitude), nested.magnitude * Floats(leaf.data[0]));
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
    if (candidate.kind >= LeafKind::mesh) {
      hits.distance = distance;
      hits.order = order;
      intersect_nested(g, candidate, active, hits);
      const Mask changed = ~((distance == hits.distance) & (order == hits.order));
      distance = hits.distance;
      order = hits.order;
      leaf = select(changed, Ints(no_leaf), leaf);
      found |= changed;
    } else {
      const Crossing crossing = cross_shape(g, candidate, active, *this);
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
      const Crossing crossing = cross_shape(g, candidate, active, *this);
      blocked |= active & crossing.hit & wants(crossing.distance, candidate);
    }
  }
  PENUMBRA_INLINE Mask wants(Floats t, const Leaf&) const { return t < farthest; }
  PENUMBRA_INLINE bool done(Mask all) const { return none(all & ~blocked); }
  PENUMBRA_INLINE Mask still_wanted(Mask active, Floats) const { return active & ~blocked; }
};

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
        stack[waiting++] = a_first ? Waiting{b.enter, in_b, node.child[1]} : Waiting{a.enter, in_a, node.child[0]};
        current = node.child[a_first ? 0 : 1];
        lanes = a_first ? in_a : in_b;
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

// Fills in the lanes of `hits` that meet something of the group nearer than they did so far. Of the `fresh` hits of a
// new ray only distance and order are defined.
template <bool fresh>
PENUMBRA_INLINE void find_nearest(const World& world, std::uint32_t group, const Rays& rays, Mask active, Hits& hits) {
  bool defined = !fresh;
  if (fresh && world.groups[group].has_nested) {
    hits.clear();
    defined = true;
  }
  const GroupRays g(world, world.groups[group], rays, active);
  NearestSearch search(hits);
  traverse(g, world.groups[group].root, active, search);

  hits.distance = search.distance;
  hits.order = search.order;
  hits.found = fresh ? search.found : hits.found | search.found;
  alignas(64) std::uint32_t leaf_of_lane[lane_count];
  store(leaf_of_lane, search.leaf);
  Mask open = search.found & ~(search.leaf == Ints(NearestSearch::no_leaf));
  while (any(open)) {
    const std::uint32_t index = leaf_of_lane[__builtin_ctz(bits(open))];
    const Mask same = open & (search.leaf == Ints(index));
    if (!defined && bits(same) == bits(open)) {
      finish_hit<true>(g, world.leaves[index], same, hits);
      return;
    }
    if (!defined) hits.clear();
    defined = true;
    finish_hit<false>(g, world.leaves[index], same, hits);
    open = open & ~same;
  }
  if (!defined) hits.clear();
}

inline void intersect_group(const World& world, std::uint32_t group, const Rays& rays, Mask active, Hits& hits) {
  find_nearest<false>(world, group, rays, active, hits);
}

inline Mask occluded_group(const World& world, std::uint32_t group, const Rays& rays, Floats farthest, Mask active) {
  const GroupRays g(world, world.groups[group], rays, active);
  AnySearch search(farthest);
  traverse(g, world.groups[group].root, active, search);
  return search.blocked;
}

// What the rays hit first, nearer than `farthest`.
__attribute__((noinline)) inline Hits intersect(const World& world, const Rays& rays, Floats farthest, Mask active) {
  Hits hits(farthest);
  find_nearest<true>(world, 0, rays, active, hits);
  return hits;
}

// Which of the rays meet anything nearer than `farthest`.
inline Mask occluded(const World& world, const Rays& rays, Floats farthest, Mask active) {
  return occluded_group(world, 0, rays, farthest, active);
}

}  // namespace penumbra::PENUMBRA_KERNEL
