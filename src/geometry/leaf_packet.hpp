// Packets of rays against one leaf that holds a shape: where they cross it, and what there is to know of the hit.
#pragma once

#include "geometry/group_rays.hpp"

namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE ShapeRays rays_of_shape(const GroupRays& g, const Leaf& leaf) {
  return {local_origin(g.world, leaf, g.rays), local_direction(g.world, leaf, g.rays), g.rays.nearest,
          g.rays.unit && leaf.placement == no_placement};
}

// Where the rays cross the shape of a leaf. What the search does not want may be left out.
template <typename Shape, typename Search>
PENUMBRA_INLINE Crossing cross_shape(const Shape& shape, const GroupRays& g, const Leaf& leaf, Mask, const Search&) {
  return first_crossing(shape, rays_of_shape(g, leaf));
}
template <typename Search>
PENUMBRA_INLINE Crossing cross_shape(const LeafTriangle& triangle, const GroupRays& g, const Leaf& leaf, Mask active,
                                     const Search& search) {
  const Float3 origin = local_origin(g.world, leaf, g.rays);
  const Float3 a = broadcast3(triangle.a) - origin;
  const SeenPlane plane(broadcast3(triangle.normal), a, g.rays.direction);
  const auto may_meet = [&](Mask lanes) { return any(lanes) || any(active & plane.grazing(g.rays.direction)); };
  if (!may_meet(active & plane.ahead()) || !may_meet(active & search.wants(plane.distance(), leaf))) {
    return {Mask(false), Floats(0)};
  }
  return cross_triangle({a, broadcast3(triangle.b) - origin, broadcast3(triangle.c) - origin, plane}, g.rays.direction,
                        g.rays.nearest, g.shear());
}
template <typename Search>
PENUMBRA_INLINE Crossing cross_leaf(const GroupRays& g, const Leaf& leaf, Mask active, const Search& search) {
  const auto cross = [&](const auto& shape) __attribute__((always_inline)) {
    return cross_shape(shape, g, leaf, active, search);
  };
  return with_shape(leaf, cross);
}

// Fills in `hits` for the lanes that hit this leaf at `distance`; where `whole`, for all lanes.
template <bool whole>
PENUMBRA_INLINE void finish_hit(const GroupRays& g, const Leaf& leaf, Mask lanes, Hits& hits) {
  const ShapeRays rays = rays_of_shape(g, leaf);
  const auto at_hit = [&](const auto& shape) __attribute__((always_inline)) {
    return surface_at(shape, rays, hits.distance);
  };
  auto [point, normal] = with_shape(leaf, at_hit);
  if (leaf.placement != no_placement) {
    const Placement& placement = g.world.placements[leaf.placement];
    point = multiply(placement.linear, point) + broadcast3(placement.translation);
    normal = normalize_any_length(multiply_transposed(placement.inverse, normal));
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

}  // namespace penumbra::PENUMBRA_KERNEL
