// The cone that opens along +y from its apex, with a flat cap. Seen from the apex, its side is where
// cos² (x² + z²) = sin² y², for the angle between axis and side. Along a ray this is a quadratic equation. It also has
// the mirror image of the cone below the apex, which the slab between apex and cap cuts off. It is set up at the point
// of the ray nearest the apex, which keeps the digits of small and far cones, as for the sphere, and solved without
// cancellation (Press et al., "Numerical Recipes", 5.6).
#pragma once

#include "geometry/shapes/shape.hpp"

namespace penumbra {

struct LeafCone {
  float apex[3];
  float top;           // y of the cap
  float sine, cosine;  // of the angle between axis and side
};

inline LeafCone leaf_of(const Cone& c) {
  LeafCone leaf{};
  set3(leaf.apex, c.apex);
  leaf.top = static_cast<float>(c.apex.y + c.height);
  const double secant = std::sqrt(1 + c.slope * c.slope);
  leaf.sine = static_cast<float>(c.slope / secant);
  leaf.cosine = static_cast<float>(1 / secant);
  return leaf;
}

inline Bounds bounds_of(const Cone& c) {
  const double radius = c.height * c.slope;
  return {c.apex - Vec3{radius, 0, radius}, c.apex + Vec3{radius, c.height, radius}};
}

inline std::optional<Cone> mapped(const Affine& m, const Cone& c) {
  const std::optional<double> scale = uniform_scale_round_y(m);
  const double along = m.column[1].y;
  if (!scale || along < 0) return std::nullopt;
  return Cone{transform_point(m, c.apex), c.height * along, c.slope * *scale / along};
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

// Where the rays are inside the endless cone (steep ones also inside its other half), and between apex and cap.
struct ConeSpans {
  Mask meets_side;
  Interval side, slab;

  PENUMBRA_INLINE ConeSpans(const LeafCone& cone, const ShapeRays& rays) {
    const Float3 d = rays.direction;
    const Float3 from_apex = rays.origin - broadcast3(cone.apex);
    const Floats approach = -dot(from_apex, d) / dot(d, d);
    const Float3 closest = from_apex + d * approach;
    const Floats cosine2 = Floats(cone.cosine) * Floats(cone.cosine);
    const Floats sine2 = Floats(cone.sine) * Floats(cone.sine);
    const auto form = [&](Float3 u, Float3 v) { return cosine2 * (u.x * v.x + u.z * v.z) - sine2 * (u.y * v.y); };
    const Floats a = form(d, d), b = form(closest, d), c = form(closest, closest);
    const Floats discriminant = b * b - a * c;
    const Floats sum = -divisor(b + copysign(sqrt(max(discriminant, Floats(0))), b));
    const Floats p = sum / a, q = c / sum;
    const Floats near = approach + min(p, q), far = approach + max(p, q);
    // A ray that is steeper than the side is inside one half before the first root, and inside the other after the
    // second.
    const Mask steep = a < Floats(0);
    const Floats dy = divisor(d.y);
    const Mask up = dy > Floats(0);
    const Floats infinity = Floats(__builtin_inff());
    meets_side = steep | (discriminant >= Floats(0));
    side = {select(steep, select(up, far, -infinity), near), select(steep, select(up, infinity, near), far)};

    const Floats at_apex = -from_apex.y / dy;
    const Floats at_cap = (Floats(cone.top) - rays.origin.y) / dy;
    slab = {min(at_apex, at_cap), max(at_apex, at_cap)};
  }

  PENUMBRA_INLINE Interval inside() const { return {max(side.enter, slab.enter), min(side.leave, slab.leave)}; }
};

PENUMBRA_INLINE Crossing first_crossing(const LeafCone& cone, const ShapeRays& rays) {
  const ConeSpans spans(cone, rays);
  const Interval inside = spans.inside();
  return first_beyond(rays, spans.meets_side & (inside.enter <= inside.leave), inside);
}

// Side or cap: whichever is at that distance, as for the faces of a box. At the apex, the normal points down the axis.
PENUMBRA_INLINE SurfacePoint surface_at(const LeafCone& cone, const ShapeRays& rays, Floats distance) {
  const ConeSpans spans(cone, rays);
  const Mask entering = spans.inside().enter == distance;
  const Floats outward = select(entering, -rays.direction.y, rays.direction.y);
  const Mask on_cap = (select(entering, spans.slab.enter, spans.slab.leave) == distance) & (outward > Floats(0));

  const Float3 apex = broadcast3(cone.apex);
  const Floats sine = Floats(cone.sine), cosine = Floats(cone.cosine);
  const Float3 point = rays.at(distance);
  const Float3 from_apex = point - apex;
  const Floats radius = sqrt(from_apex.x * from_apex.x + from_apex.z * from_apex.z);
  const Mask off_axis = radius > Floats(1e-30f);
  const Floats x = keep(off_axis, from_apex.x / radius), z = keep(off_axis, from_apex.z / radius);
  // Straight onto the side: so far down it from the apex.
  const Floats along = max(radius * sine + from_apex.y * cosine, Floats(0));
  const Float3 side{x * (along * sine), along * cosine, z * (along * sine)};
  const Float3 side_normal{x * cosine, select(off_axis, -sine, Floats(-1)), z * cosine};
  return {select(on_cap, Float3{point.x, Floats(cone.top), point.z}, apex + side),
          select(on_cap, Float3{Floats(0), Floats(1), Floats(0)}, side_normal)};
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
