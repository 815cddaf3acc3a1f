// Packets of rays against one leaf that holds a shape: where they cross it, and what there is to know of the hit.
#pragma once

#include "geometry/group_rays.hpp"

namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE ShapeRays rays_of_shape(const GroupRays& g, const Leaf& leaf, Floats nearest, Mask inside) {
  return {local_origin(g.world, leaf, g.rays), local_direction(g.world, leaf, g.rays), nearest,
          g.rays.unit && leaf.placement == no_placement, inside};
}

// Which crossings of a leaf are asked for.
struct Wanted {
  Mask active;
  Mask inside;  // lanes that start on the leaf and go into it
  Floats nearest;
};

// Where the rays cross the shape of a leaf. What the search does not want may be left out.
template <typename Shape, typename Search>
PENUMBRA_INLINE Crossing cross_shape(const Shape& shape, const GroupRays& g, const Leaf& leaf, const Wanted& wanted,
                                     const Search&) {
  return first_crossing(shape, rays_of_shape(g, leaf, wanted.nearest, wanted.inside));
}
template <typename Search>
PENUMBRA_INLINE Crossing cross_shape(const LeafTriangle& triangle, const GroupRays& g, const Leaf& leaf,
                                     const Wanted& wanted, const Search& search) {
  const Float3 origin = local_origin(g.world, leaf, g.rays);
  const Float3 a = broadcast3(triangle.a) - origin;
  const SeenPlane plane(broadcast3(triangle.normal), a, g.rays.direction);
  const auto may_meet = [&](Mask lanes) { return any(lanes) || any(wanted.active & plane.grazing(g.rays.direction)); };
  const Mask ahead = g.rays.start ? plane.ahead_from(-wanted.nearest) : plane.ahead();
  if (!may_meet(wanted.active & ahead) || !may_meet(wanted.active & ahead & search.may_want(plane.distance()))) {
    return {Mask(false), Floats(0), Mask(false)};
  }
  return cross_triangle({a, broadcast3(triangle.b) - origin, broadcast3(triangle.c) - origin, plane}, g.rays.direction,
                        wanted.nearest, g.shear());
}
template <typename Search>
PENUMBRA_INLINE Crossing cross_leaf(const GroupRays& g, const Leaf& leaf, const Wanted& wanted, const Search& search) {
  const auto cross = [&](const auto& shape) __attribute__((always_inline)) {
    return cross_shape(shape, g, leaf, wanted, search);
  };
  return with_shape(leaf, cross);
}

// Fills in what is smooth of a hit, where leaf `index` is a triangle whose corners have normals.
inline void finish_smooth_hit(const GroupRays& g, std::uint32_t index, const SurfacePoint& surface, Mask lanes,
                              Hits& hits) {
  const World& world = g.world;
  const Leaf& leaf = world.leaves[index];
  const std::uint32_t triangle = world.leaf_normals[index];
  hits.smooth = hits.smooth & ~lanes;
  if (triangle == TriangleRange::flat) return;
  const float* const corners[3] = {leaf.triangle.a, leaf.triangle.b, leaf.triangle.c};
  Corner corner[3];
  for (std::size_t k = 0; k < 3; k++) {
    const float* n = normal_of(*world.triangles, triangle, k);
    corner[k] = {{Floats(corners[k][0]), Floats(corners[k][1]), Floats(corners[k][2])},
                 {Floats(n[0]), Floats(n[1]), Floats(n[2])}};
  }
  hits.set_smooth(lanes, smooth_at(corner, surface.point, surface.normal, g.rays.direction));
}

// The surface of a leaf at `distance`, before its motion.
PENUMBRA_INLINE SurfacePoint surface_of(const GroupRays& g, const Leaf& leaf, Floats distance) {
  const ShapeRays rays = rays_of_shape(g, leaf, g.rays.nearest, Mask(false));
  const auto at_hit = [&](const auto& shape) __attribute__((always_inline)) {
    return surface_at(shape, rays, distance);
  };
  SurfacePoint surface = with_shape(leaf, at_hit);
  if (leaf.placement != no_placement) {
    const Placement& placement = g.world.placements[leaf.placement];
    surface.point = multiply(placement.linear, surface.point) + broadcast3(placement.translation);
    surface.normal = normalize_any_length(multiply_transposed(placement.inverse, surface.normal));
  }
  return surface;
}

// Fills in `hits` for the lanes that hit leaf `index` at `distance`; where `whole`, for all lanes.
template <bool whole>
PENUMBRA_INLINE void finish_hit(const GroupRays& g, std::uint32_t index, Mask lanes, Hits& hits) {
  const Leaf& leaf = g.world.leaves[index];
  const SurfacePoint surface = surface_of(g, leaf, hits.distance);
  Float3 point = surface.point;
  const auto set = [&](auto& field, auto value) {
    if constexpr (whole) {
      field = value;
    } else {
      field = select(lanes, value, field);
    }
  };
  if (g.world.has_textures) set(hits.texture_point, point + broadcast3(g.origin));
  if (leaf.moves) point = point + broadcast3(leaf.motion) * g.rays.time;
  set(hits.point, point);
  set(hits.normal, surface.normal);
  if (g.world.has_normals) finish_smooth_hit(g, index, surface, lanes, hits);
  set(hits.surface, Ints(leaf.target));
  set(hits.place, Ints(g.place_of(leaf)));
  set(hits.slack, Floats(leaf.slack));
  const Mask triangle(leaf.kind == LeafKind::triangle);
  hits.two_sided = whole ? triangle : (hits.two_sided & ~lanes) | (lanes & triangle);
}

}  // namespace penumbra::PENUMBRA_KERNEL
