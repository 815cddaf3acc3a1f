// The sphere. The point of closest approach to the centre is found first and the half chord from it, which keeps the
// digits that the usual quadratic formula loses for small or far spheres (Hearn and Baker; Haines et al. 2019,
// "Precision improvements"). A ground is the opposite: a large sphere whose surface passes near the origin of its
// space, where the rays are. There the distances are the roots of |o + t d|^2 - 2 (o + t d).c + (|c|^2 - r^2) = 0,
// whose constant term is small, each computed without cancellation (Press et al., "Numerical Recipes", 5.6).
#pragma once

#include "geometry/shapes/shape.hpp"

namespace penumbra {

struct LeafSphere {
  float center[3];
  float radius;
  float power;  // |c|^2 - r^2
  bool is_ground;
};

inline LeafSphere leaf_of(const Sphere& s) {
  LeafSphere leaf{};
  set3(leaf.center, s.center);
  leaf.radius = static_cast<float>(s.radius);
  const double distance = length(s.center);
  leaf.is_ground = s.radius > 256 && std::abs(distance - s.radius) < s.radius / 16;
  leaf.power = static_cast<float>((distance - s.radius) * (distance + s.radius));
  return leaf;
}

inline Bounds bounds_of(const Sphere& s) { return grow({s.center, s.center}, s.radius); }

// The tight bounds of an ellipsoid: along each axis, the length of the map's row.
inline Bounds transformed_bounds(const Affine& m, const Sphere& s) {
  Vec3 extent;
  for (int row = 0; row < 3; row++) {
    extent[row] = s.radius * length({m.column[0][row], m.column[1][row], m.column[2][row]});
  }
  const Vec3 center = transform_point(m, s.center);
  return {center - extent, center + extent};
}

inline std::optional<Sphere> mapped(const Affine& m, const Sphere& s) {
  const std::optional<double> scale = uniform_scale(m);
  if (!scale) return std::nullopt;
  return Sphere{transform_point(m, s.center), s.radius * *scale};
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

inline Crossing first_crossing_of_ground(const LeafSphere& sphere, const ShapeRays& rays) {
  const Float3 center = broadcast3(sphere.center);
  const Floats a = dot(rays.direction, rays.direction);
  const Floats b = dot(rays.direction, rays.origin - center);
  const Floats c = dot(rays.origin, rays.origin - center * Floats(2)) + Floats(sphere.power);
  const Floats discriminant = b * b - a * c;
  const Floats sum = -divisor(b + copysign(sqrt(max(discriminant, Floats(0))), b));
  const Floats p = sum / a, q = c / sum;
  return first_beyond(rays, discriminant >= Floats(0), {min(p, q), max(p, q)});
}

PENUMBRA_INLINE Crossing first_crossing(const LeafSphere& sphere, const ShapeRays& rays) {
  if (sphere.is_ground) return first_crossing_of_ground(sphere, rays);
  const Float3 to_origin = rays.origin - broadcast3(sphere.center);
  Floats approach = -dot(to_origin, rays.direction);
  Floats inverse_dd = Floats(1);
  if (!rays.unit) {
    inverse_dd = Floats(1) / dot(rays.direction, rays.direction);
    approach *= inverse_dd;
  }
  const Float3 closest = to_origin + rays.direction * approach;
  const Floats remainder = Floats(sphere.radius) * Floats(sphere.radius) - dot(closest, closest);
  const Mask meets = remainder >= Floats(0);
  if (none(meets | rays.inside)) return {meets, Floats(0), meets};
  const Floats half_chord = sqrt(max(rays.unit ? remainder : remainder * inverse_dd, Floats(0)));
  return first_beyond(rays, meets, {approach - half_chord, approach + half_chord});
}

PENUMBRA_INLINE SurfacePoint surface_at(const LeafSphere& sphere, const ShapeRays& rays, Floats distance) {
  const Float3 center = broadcast3(sphere.center);
  const Float3 point = rays.at(distance);
  const Float3 normal = normalize(point - center);
  if (sphere.is_ground) return {point, normal};
  return {center + normal * Floats(sphere.radius), normal};
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
