// The cylinder along y. With caps, the solid is what the endless round wall and the slab between the caps have in
// common; without, each crossing of the wall counts that lies between the ends.
#pragma once

#include "geometry/shapes/shape.hpp"

namespace penumbra {

struct LeafCylinder {
  float x, z, radius, y_min, y_max;
  bool capped;
};

inline LeafCylinder leaf_of(const Cylinder& c) {
  return {static_cast<float>(c.x),     static_cast<float>(c.z),     static_cast<float>(c.radius),
          static_cast<float>(c.y_min), static_cast<float>(c.y_max), c.capped};
}

inline Bounds bounds_of(const Cylinder& c) {
  return {{c.x - c.radius, c.y_min, c.z - c.radius}, {c.x + c.radius, c.y_max, c.z + c.radius}};
}

inline std::optional<Cylinder> mapped(const Affine& m, const Cylinder& c) {
  const std::optional<double> scale = uniform_scale_round_y(m);
  if (!scale) return std::nullopt;
  const Vec3 p = transform_point(m, {c.x, c.y_min, c.z});
  const Vec3 q = transform_point(m, {c.x, c.y_max, c.z});
  return Cylinder{c.radius * *scale, p.x, p.z, std::min(p.y, q.y), std::max(p.y, q.y), c.capped};
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

// Where the rays are inside the endless round wall, and between the planes of the caps.
struct CylinderSpans {
  Mask meets_wall, along_axis;
  Interval wall, caps;

  PENUMBRA_INLINE CylinderSpans(const LeafCylinder& cylinder, const ShapeRays& rays) {
    const Float3 direction = rays.direction;
    const Floats x = rays.origin.x - Floats(cylinder.x);
    const Floats z = rays.origin.z - Floats(cylinder.z);
    const Floats radius2 = Floats(cylinder.radius) * Floats(cylinder.radius);
    const Floats infinity = Floats(__builtin_inff());
    const Floats a = direction.x * direction.x + direction.z * direction.z;
    const Floats moment = x * direction.z - z * direction.x;
    const Floats discriminant = a * radius2 - moment * moment;
    along_axis = a <= Floats(1e-30f);
    const Floats inverse_a = Floats(1) / select(along_axis, Floats(1), a);
    const Floats middle = -(x * direction.x + z * direction.z) * inverse_a;
    const Floats half_chord = sqrt(max(discriminant, Floats(0))) * inverse_a;
    const Mask inside_wall = x * x + z * z <= radius2;
    meets_wall = (along_axis & inside_wall) | (~along_axis & (discriminant >= Floats(0)));
    wall = {select(along_axis, -infinity, middle - half_chord), select(along_axis, infinity, middle + half_chord)};

    const Floats dy = divisor(direction.y);
    const Floats p = (Floats(cylinder.y_min) - rays.origin.y) / dy;
    const Floats q = (Floats(cylinder.y_max) - rays.origin.y) / dy;
    caps = {min(p, q), max(p, q)};
  }

  PENUMBRA_INLINE Interval inside() const { return {max(wall.enter, caps.enter), min(wall.leave, caps.leave)}; }
};

PENUMBRA_INLINE Crossing first_crossing(const LeafCylinder& cylinder, const ShapeRays& rays) {
  const CylinderSpans spans(cylinder, rays);
  if (cylinder.capped) {
    const Interval inside = spans.inside();
    return first_beyond(rays, spans.meets_wall & (inside.enter <= inside.leave), inside);
  }
  const auto in_reach = [&](Floats t) {
    const Floats y = rays.origin.y + t * rays.direction.y;
    return (t > rays.nearest) & (y >= Floats(cylinder.y_min)) & (y <= Floats(cylinder.y_max));
  };
  const Mask on_wall = spans.meets_wall & ~spans.along_axis;
  const Mask near_hit = on_wall & in_reach(spans.wall.enter) & ~rays.inside;
  const Mask far_hit = on_wall & in_reach(spans.wall.leave);
  return {near_hit | far_hit, select(near_hit, spans.wall.enter, spans.wall.leave), ~near_hit};
}

PENUMBRA_INLINE SurfacePoint surface_at(const LeafCylinder& cylinder, const ShapeRays& rays, Floats distance) {
  const Float3 point = rays.at(distance);
  const Floats x = point.x - Floats(cylinder.x);
  const Floats z = point.z - Floats(cylinder.z);
  const Floats inverse = Floats(1) / max(sqrt(x * x + z * z), Floats(1e-30f));
  const Float3 normal{x * inverse, Floats(0), z * inverse};
  const SurfacePoint on_wall{{Floats(cylinder.x) + normal.x * Floats(cylinder.radius), point.y,
                              Floats(cylinder.z) + normal.z * Floats(cylinder.radius)},
                             normal};
  if (!cylinder.capped) return on_wall;
  // Wall or cap: whichever is at that distance, as for the faces of a box.
  const CylinderSpans spans(cylinder, rays);
  const Mask entering = spans.inside().enter == distance;
  const Mask on_cap = select(entering, spans.caps.enter, spans.caps.leave) == distance;
  const Floats outward = copysign(Floats(1), select(entering, -rays.direction.y, rays.direction.y));
  const Floats cap_y = select(outward > Floats(0), Floats(cylinder.y_max), Floats(cylinder.y_min));
  return {select(on_cap, Float3{point.x, cap_y, point.z}, on_wall.point),
          select(on_cap, Float3{Floats(0), outward, Floats(0)}, on_wall.normal)};
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
