// The box along the axes. Distances to its planes are by division, not by the inverse of the direction: a plane of one
// coordinate is at the same distance whatever shape it belongs to.
#pragma once

#include "geometry/shapes/shape.hpp"

namespace penumbra {

struct LeafBox {
  float lo[3], hi[3];
};

inline LeafBox leaf_of(const Box& b) {
  LeafBox leaf{};
  set3(leaf.lo, b.lo);
  set3(leaf.hi, b.hi);
  return leaf;
}

inline Bounds bounds_of(const Box& b) { return {b.lo, b.hi}; }

inline std::optional<Box> mapped(const Affine& m, const Box& b) {
  if (!maps_axes_to_axes(m)) return std::nullopt;
  const Vec3 p = transform_point(m, b.lo);
  const Vec3 q = transform_point(m, b.hi);
  return Box{min(p, q), max(p, q)};
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

// The distances to the two planes of each axis.
struct BoxPlanes {
  Float3 near, far;

  PENUMBRA_INLINE BoxPlanes(const LeafBox& box, const ShapeRays& rays) {
    const Float3 d = divisor(rays.direction);
    const Float3 lo = broadcast3(box.lo) - rays.origin;
    const Float3 hi = broadcast3(box.hi) - rays.origin;
    const Float3 a{lo.x / d.x, lo.y / d.y, lo.z / d.z};
    const Float3 b{hi.x / d.x, hi.y / d.y, hi.z / d.z};
    near = {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
    far = {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
  }
  PENUMBRA_INLINE Floats enter() const { return max(max(near.x, near.y), near.z); }
  PENUMBRA_INLINE Floats leave() const { return min(min(far.x, far.y), far.z); }
};

PENUMBRA_INLINE Crossing first_crossing(const LeafBox& box, const ShapeRays& rays) {
  const BoxPlanes planes(box, rays);
  return first_beyond(rays, planes.enter() <= planes.leave(), {planes.enter(), planes.leave()});
}

// The face is the one at that distance, and faces the ray where it enters: near an edge the point alone would not tell.
PENUMBRA_INLINE SurfacePoint surface_at(const LeafBox& box, const ShapeRays& rays, Floats distance) {
  const BoxPlanes planes(box, rays);
  const Mask entering = planes.enter() == distance;
  const Float3 at = select(entering, planes.near, planes.far);
  const Mask on_x = at.x == distance;
  const Mask on_y = ~on_x & (at.y == distance);
  const Mask on_z = ~on_x & ~on_y;
  const Float3 outward = select(entering, -rays.direction, rays.direction);
  const Floats one = Floats(1);
  const Float3 normal{keep(on_x, copysign(one, outward.x)), keep(on_y, copysign(one, outward.y)),
                      keep(on_z, copysign(one, outward.z))};
  const Float3 point = rays.at(distance);
  const auto face = [&](int axis, Floats side) {
    return select(side > Floats(0), Floats(box.hi[axis]), Floats(box.lo[axis]));
  };
  return {{select(on_x, face(0, normal.x), point.x), select(on_y, face(1, normal.y), point.y),
           select(on_z, face(2, normal.z), point.z)},
          normal};
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
