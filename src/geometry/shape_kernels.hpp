// Where W rays meet one shape: sphere, box, cylinder. Each gives the smallest distance beyond `nearest`, and the
// outward normal and exact surface point for lanes that were hit. Origin and direction are in the shape's own space.
#pragma once

#include "geometry/rays.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Crossing {
  Mask hit;
  Floats distance;
};

// The nearer of two distances beyond `nearest`.
PENUMBRA_INLINE Crossing first_beyond(Floats nearest, Mask candidates, Floats near, Floats far) {
  const Floats t = select(near > nearest, near, far);
  return {candidates & (t > nearest), t};
}

// The closest approach to the centre is found first and the half chord from it, which keeps the digits that the usual
// quadratic formula loses for small or far spheres (Hearn and Baker; Haines et al. 2019, "Precision improvements").
PENUMBRA_INLINE Crossing cross_sphere(const float* sphere, Float3 origin, Float3 direction, Floats nearest, bool unit) {
  const Float3 to_origin = origin - broadcast3(sphere);
  Floats approach = -dot(to_origin, direction);
  Floats inverse_dd = Floats(1);
  if (!unit) {
    inverse_dd = Floats(1) / dot(direction, direction);
    approach *= inverse_dd;
  }
  const Float3 closest = to_origin + direction * approach;
  const Floats remainder = Floats(sphere[3]) * Floats(sphere[3]) - dot(closest, closest);
  const Mask meets = remainder >= Floats(0);
  if (none(meets)) return {meets, Floats(0)};
  const Floats half_chord = sqrt(unit ? remainder : remainder * inverse_dd);
  return first_beyond(nearest, meets, approach - half_chord, approach + half_chord);
}

PENUMBRA_INLINE void sphere_surface(const float* sphere, Float3& point, Float3& normal) {
  normal = normalize(point - broadcast3(sphere));
  point = broadcast3(sphere) + normal * Floats(sphere[3]);
}

// One over the direction, finite where it is zero, so that no bound of a slab is ever not a number.
PENUMBRA_INLINE Float3 safe_inverse(Float3 d) {
  const auto inverse = [](Floats x) { return Floats(1) / copysign(max(abs(x), Floats(1e-30f)), x); };
  return {inverse(d.x), inverse(d.y), inverse(d.z)};
}

struct Interval {
  Floats enter, leave;
};

// Where the rays are inside the box lo..hi (six floats), by slabs (Kay and Kajiya 1986).
PENUMBRA_INLINE Interval cross_slabs(const float* box, Float3 origin, Float3 inverse_direction) {
  const Float3 a = (broadcast3(box) - origin) * inverse_direction;
  const Float3 b = (broadcast3(box + 3) - origin) * inverse_direction;
  return {max(max(min(a.x, b.x), min(a.y, b.y)), min(a.z, b.z)), min(min(max(a.x, b.x), max(a.y, b.y)), max(a.z, b.z))};
}

// By division, not by the inverse: a plane of one coordinate is at the same distance whatever shape it belongs to.
PENUMBRA_INLINE Crossing cross_box(const float* box, Float3 origin, Float3 direction, Floats nearest) {
  const auto divisor = [](Floats x) { return copysign(max(abs(x), Floats(1e-30f)), x); };
  const Float3 d{divisor(direction.x), divisor(direction.y), divisor(direction.z)};
  const Float3 lo = broadcast3(box) - origin;
  const Float3 hi = broadcast3(box + 3) - origin;
  const Float3 a{lo.x / d.x, lo.y / d.y, lo.z / d.z};
  const Float3 b{hi.x / d.x, hi.y / d.y, hi.z / d.z};
  const Floats enter = max(max(min(a.x, b.x), min(a.y, b.y)), min(a.z, b.z));
  const Floats leave = min(min(max(a.x, b.x), max(a.y, b.y)), max(a.z, b.z));
  return first_beyond(nearest, enter <= leave, enter, leave);
}

// The face is the one whose plane the point is nearest to, in units of the box's half extent.
PENUMBRA_INLINE void box_surface(const float* box, Float3& point, Float3& normal) {
  const Floats half = Floats(0.5f);
  const Float3 center = (broadcast3(box) + broadcast3(box + 3)) * half;
  const Float3 extent = (broadcast3(box + 3) - broadcast3(box)) * half;
  const Float3 from_center = point - center;
  const Floats tiny = Floats(1e-30f);
  const Floats depth_x = (abs(from_center.x) - extent.x) / max(extent.x, tiny);
  const Floats depth_y = (abs(from_center.y) - extent.y) / max(extent.y, tiny);
  const Floats depth_z = (abs(from_center.z) - extent.z) / max(extent.z, tiny);
  const Mask on_x = (depth_x >= depth_y) & (depth_x >= depth_z);
  const Mask on_y = ~on_x & (depth_y >= depth_z);
  const Mask on_z = ~on_x & ~on_y;
  normal = {keep(on_x, copysign(Floats(1), from_center.x)), keep(on_y, copysign(Floats(1), from_center.y)),
            keep(on_z, copysign(Floats(1), from_center.z))};
  const auto face = [&](int axis, Floats side) {
    return select(side > Floats(0), Floats(box[3 + axis]), Floats(box[axis]));
  };
  point = {select(on_x, face(0, from_center.x), point.x), select(on_y, face(1, from_center.y), point.y),
           select(on_z, face(2, from_center.z), point.z)};
}

// data: x, z, radius, y_min, y_max. With caps, the solid is what the round wall and the slab have in common; without,
// each crossing of the wall counts that lies between the ends.
PENUMBRA_INLINE Crossing cross_cylinder(const float* data, Float3 origin, Float3 direction, Floats nearest,
                                        bool capped) {
  const Floats x = origin.x - Floats(data[0]);
  const Floats z = origin.z - Floats(data[1]);
  const Floats radius2 = Floats(data[2]) * Floats(data[2]);
  const Floats infinity = Floats(__builtin_inff());

  const Floats a = direction.x * direction.x + direction.z * direction.z;
  const Floats moment = x * direction.z - z * direction.x;
  const Floats discriminant = a * radius2 - moment * moment;
  const Mask along_axis = a <= Floats(1e-30f);
  const Floats inverse_a = Floats(1) / select(along_axis, Floats(1), a);
  const Floats middle = -(x * direction.x + z * direction.z) * inverse_a;
  const Floats half_chord = sqrt(max(discriminant, Floats(0))) * inverse_a;
  const Mask inside_wall = x * x + z * z <= radius2;
  const Mask meets_wall = (along_axis & inside_wall) | (~along_axis & (discriminant >= Floats(0)));
  const Floats wall_enter = select(along_axis, -infinity, middle - half_chord);
  const Floats wall_leave = select(along_axis, infinity, middle + half_chord);

  if (capped) {
    const Floats divisor = copysign(max(abs(direction.y), Floats(1e-30f)), direction.y);
    const Floats p = (Floats(data[3]) - origin.y) / divisor;
    const Floats q = (Floats(data[4]) - origin.y) / divisor;
    const Floats enter = max(wall_enter, min(p, q));
    const Floats leave = min(wall_leave, max(p, q));
    return first_beyond(nearest, meets_wall & (enter <= leave), enter, leave);
  }
  const auto in_reach = [&](Floats t) {
    const Floats y = origin.y + t * direction.y;
    return (t > nearest) & (y >= Floats(data[3])) & (y <= Floats(data[4]));
  };
  const Mask on_wall = meets_wall & ~along_axis;
  const Mask near_hit = on_wall & in_reach(wall_enter);
  const Mask far_hit = on_wall & in_reach(wall_leave);
  return {near_hit | far_hit, select(near_hit, wall_enter, wall_leave)};
}

PENUMBRA_INLINE void cylinder_surface(const float* data, bool capped, Float3& point, Float3& normal) {
  const Floats x = point.x - Floats(data[0]);
  const Floats z = point.z - Floats(data[1]);
  const Floats from_axis = sqrt(x * x + z * z);
  const Floats inverse = Floats(1) / max(from_axis, Floats(1e-30f));
  Float3 wall_normal{x * inverse, Floats(0), z * inverse};
  Float3 wall_point{Floats(data[0]) + wall_normal.x * Floats(data[2]), point.y,
                    Floats(data[1]) + wall_normal.z * Floats(data[2])};
  if (!capped) {
    point = wall_point;
    normal = wall_normal;
    return;
  }
  const Floats below_cap = min(abs(point.y - Floats(data[3])), abs(point.y - Floats(data[4])));
  const Mask on_cap = below_cap < abs(from_axis - Floats(data[2]));
  const Mask on_top = abs(point.y - Floats(data[4])) < abs(point.y - Floats(data[3]));
  const Float3 cap_normal{Floats(0), select(on_top, Floats(1), Floats(-1)), Floats(0)};
  const Float3 cap_point{point.x, select(on_top, Floats(data[4]), Floats(data[3])), point.z};
  normal = select(on_cap, cap_normal, wall_normal);
  point = select(on_cap, cap_point, wall_point);
}

}  // namespace penumbra::PENUMBRA_KERNEL
