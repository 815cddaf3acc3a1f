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

// The distances to the two planes of each axis. By division, not by the inverse: a plane of one coordinate is at the
// same distance whatever shape it belongs to.
struct BoxPlanes {
  Float3 near, far;

  PENUMBRA_INLINE BoxPlanes(const float* box, Float3 origin, Float3 direction) {
    const auto divisor = [](Floats x) { return copysign(max(abs(x), Floats(1e-30f)), x); };
    const Float3 d{divisor(direction.x), divisor(direction.y), divisor(direction.z)};
    const Float3 lo = broadcast3(box) - origin;
    const Float3 hi = broadcast3(box + 3) - origin;
    const Float3 a{lo.x / d.x, lo.y / d.y, lo.z / d.z};
    const Float3 b{hi.x / d.x, hi.y / d.y, hi.z / d.z};
    near = {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
    far = {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
  }
  PENUMBRA_INLINE Floats enter() const { return max(max(near.x, near.y), near.z); }
  PENUMBRA_INLINE Floats leave() const { return min(min(far.x, far.y), far.z); }
};

PENUMBRA_INLINE Crossing cross_box(const float* box, Float3 origin, Float3 direction, Floats nearest) {
  const BoxPlanes planes(box, origin, direction);
  return first_beyond(nearest, planes.enter() <= planes.leave(), planes.enter(), planes.leave());
}

// The face is the one at that distance, and faces the ray where it enters: near an edge the point alone would not tell.
PENUMBRA_INLINE void box_surface(const float* box, Float3 origin, Float3 direction, Floats distance, Float3& point,
                                 Float3& normal) {
  const BoxPlanes planes(box, origin, direction);
  const Mask entering = planes.enter() == distance;
  const Float3 at = select(entering, planes.near, planes.far);
  const Mask on_x = at.x == distance;
  const Mask on_y = ~on_x & (at.y == distance);
  const Mask on_z = ~on_x & ~on_y;
  const Float3 outward = select(entering, -direction, direction);
  const Floats one = Floats(1);
  normal = {keep(on_x, copysign(one, outward.x)), keep(on_y, copysign(one, outward.y)),
            keep(on_z, copysign(one, outward.z))};
  const auto face = [&](int axis, Floats side) {
    return select(side > Floats(0), Floats(box[3 + axis]), Floats(box[axis]));
  };
  point = {select(on_x, face(0, normal.x), point.x), select(on_y, face(1, normal.y), point.y),
           select(on_z, face(2, normal.z), point.z)};
}

// Where the rays are inside the endless round wall, and between the planes of the caps.
struct CylinderSpans {
  Mask meets_wall, along_axis;
  Interval wall, caps;

  // data: x, z, radius, y_min, y_max
  PENUMBRA_INLINE CylinderSpans(const float* data, Float3 origin, Float3 direction) {
    const Floats x = origin.x - Floats(data[0]);
    const Floats z = origin.z - Floats(data[1]);
    const Floats radius2 = Floats(data[2]) * Floats(data[2]);
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

    const Floats divisor = copysign(max(abs(direction.y), Floats(1e-30f)), direction.y);
    const Floats p = (Floats(data[3]) - origin.y) / divisor;
    const Floats q = (Floats(data[4]) - origin.y) / divisor;
    caps = {min(p, q), max(p, q)};
  }
};

// data: x, z, radius, y_min, y_max. With caps, the solid is what the round wall and the slab have in common; without,
// each crossing of the wall counts that lies between the ends.
PENUMBRA_INLINE Crossing cross_cylinder(const float* data, Float3 origin, Float3 direction, Floats nearest,
                                        bool capped) {
  const CylinderSpans spans(data, origin, direction);
  if (capped) {
    const Floats enter = max(spans.wall.enter, spans.caps.enter);
    const Floats leave = min(spans.wall.leave, spans.caps.leave);
    return first_beyond(nearest, spans.meets_wall & (enter <= leave), enter, leave);
  }
  const auto in_reach = [&](Floats t) {
    const Floats y = origin.y + t * direction.y;
    return (t > nearest) & (y >= Floats(data[3])) & (y <= Floats(data[4]));
  };
  const Mask on_wall = spans.meets_wall & ~spans.along_axis;
  const Mask near_hit = on_wall & in_reach(spans.wall.enter);
  const Mask far_hit = on_wall & in_reach(spans.wall.leave);
  return {near_hit | far_hit, select(near_hit, spans.wall.enter, spans.wall.leave)};
}

PENUMBRA_INLINE void wall_surface(const float* data, Float3& point, Float3& normal) {
  const Floats x = point.x - Floats(data[0]);
  const Floats z = point.z - Floats(data[1]);
  const Floats inverse = Floats(1) / max(sqrt(x * x + z * z), Floats(1e-30f));
  normal = {x * inverse, Floats(0), z * inverse};
  point = {Floats(data[0]) + normal.x * Floats(data[2]), point.y, Floats(data[1]) + normal.z * Floats(data[2])};
}

// Wall or cap: whichever is at that distance, as for the faces of a box.
PENUMBRA_INLINE void capped_surface(const float* data, Float3 origin, Float3 direction, Floats distance, Float3& point,
                                    Float3& normal) {
  const CylinderSpans spans(data, origin, direction);
  const Mask entering = max(spans.wall.enter, spans.caps.enter) == distance;
  const Mask on_cap = select(entering, spans.caps.enter, spans.caps.leave) == distance;
  const Floats outward = copysign(Floats(1), select(entering, -direction.y, direction.y));
  const Float3 cap_point{point.x, select(outward > Floats(0), Floats(data[4]), Floats(data[3])), point.z};
  wall_surface(data, point, normal);
  normal = select(on_cap, Float3{Floats(0), outward, Floats(0)}, normal);
  point = select(on_cap, cap_point, point);
}

}  // namespace penumbra::PENUMBRA_KERNEL
