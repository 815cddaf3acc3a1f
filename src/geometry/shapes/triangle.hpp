// The triangle. W rays meet it without gaps along shared edges and corners: the corners are projected along the ray
// to a plane, each by the same arithmetic whatever triangle it belongs to, and the signs of the edge functions of the
// projected corners are never wrong, only sometimes zero, which counts as inside (Woop, Benthin and Wald 2013).
// The distance is that of the triangle's plane, so that triangles of one axis-aligned plane tie exactly.
#pragma once

#include "geometry/shapes/shape.hpp"

namespace penumbra {

struct LeafTriangle {
  float a[3], b[3], c[3];
  float normal[3];  // unit, along (B-A)x(C-A)
};

// The normal is that of the triangles of a mesh (geometry/mesh_packet.hpp) to the bit, so that both rooms agree on what
// is equally far. Divided, not multiplied by an inverse, the normal of an axis-aligned plane is exactly one axis, and
// all triangles in the plane are equally far. Where single precision has no answer, the double one.
inline LeafTriangle leaf_of_triangle(Vec3 a, Vec3 b, Vec3 c) {
  LeafTriangle leaf{};
  set3(leaf.a, a);
  set3(leaf.b, b);
  set3(leaf.c, c);
  const float ux = leaf.b[0] - leaf.a[0], uy = leaf.b[1] - leaf.a[1], uz = leaf.b[2] - leaf.a[2];
  const float vx = leaf.c[0] - leaf.a[0], vy = leaf.c[1] - leaf.a[1], vz = leaf.c[2] - leaf.a[2];
  const float n[3] = {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
  const float size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int i = 0; i < 3; i++) leaf.normal[i] = n[i] / size;
  if (!std::isnormal(size)) set3(leaf.normal, normalize(cross(b - a, c - a)));
  return leaf;
}

// Corner 0, 1 or 2 of a triangle.
inline Vec3 corner_of(const TriangleStore& store, std::size_t triangle, std::size_t corner) {
  const float* p = &store.vertices[std::size_t{3} * store.indices[3 * triangle + corner]];
  return {p[0], p[1], p[2]};
}

// The normal of a corner of a triangle that is not flat, by its place in `normal_numbers`.
inline const float* normal_of(const TriangleStore& store, std::size_t triangle, std::size_t corner) {
  return &store.normals[3 * (std::size_t{store.normal_numbers[3 * triangle + corner]} - 1)];
}

inline Bounds bounds_of(const TriangleStore& store, TriangleRange range) {
  Bounds bounds;
  for (std::size_t i = 0; i < range.count; i++) {
    for (std::size_t corner = 0; corner < 3; corner++) {
      bounds = include(bounds, corner_of(store, range.first + i, corner));
    }
  }
  return bounds;
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

// The shear that turns the ray's direction into its largest axis.
struct RayShear {
  Mask z_largest, y_largest;
  int agreed_axis = -1;     // the largest axis, where all rays of a packet agree on it
  Floats slope_x, slope_y;  // minus the two other axes per largest
  Floats inverse;           // one over the largest

  PENUMBRA_INLINE RayShear() = default;
  PENUMBRA_INLINE RayShear(Float3 d, Mask active) {
    const Float3 size{abs(d.x), abs(d.y), abs(d.z)};
    z_largest = (size.z >= size.x) & (size.z >= size.y);
    y_largest = ~z_largest & (size.y >= size.x);
    const std::uint32_t all = bits(active), on_z = bits(z_largest) & all, on_y = bits(y_largest) & all;
    agreed_axis = on_z == all ? 2 : on_y == all ? 1 : (on_z | on_y) == 0 ? 0 : -1;
    const Turned turned = agreed_axis == 2   ? turn<2>(d)
                          : agreed_axis == 1 ? turn<1>(d)
                          : agreed_axis == 0 ? turn<0>(d)
                                             : turn<-1>(d);
    inverse = Floats(1) / turned.along;
    slope_x = -(turned.next * inverse);
    slope_y = -(turned.last * inverse);
  }

  // A vector's components: along the largest axis, and the two that follow it cyclically.
  struct Turned {
    Floats along, next, last;
  };
  template <int axis>
  PENUMBRA_INLINE Turned turn(Float3 v) const {
    if constexpr (axis == 0) return {v.x, v.y, v.z};
    if constexpr (axis == 1) return {v.y, v.z, v.x};
    if constexpr (axis == 2) return {v.z, v.x, v.y};
    return {select(z_largest, v.z, select(y_largest, v.y, v.x)), select(z_largest, v.x, select(y_largest, v.z, v.y)),
            select(z_largest, v.y, select(y_largest, v.x, v.z))};
  }

  // A corner, relative to the origin, as the ray sees it: in the plane across, and the distance along the ray.
  struct Projected {
    Floats x, y, along;
    PENUMBRA_INLINE Floats distance(const RayShear& shear) const { return along * shear.inverse; }
  };
  template <int axis>
  PENUMBRA_INLINE Projected project(Float3 corner) const {
    const Turned c = turn<axis>(corner);
    return {c.next + c.along * slope_x, c.last + c.along * slope_y, c.along};
  }
};

// How the rays stand to the plane of a triangle.
struct SeenPlane {
  Floats cosine, height;  // of the normal with the direction, and with what leads from the origin to the plane

  PENUMBRA_INLINE SeenPlane(Float3 normal, Float3 corner, Float3 direction)
      : cosine(dot(normal, direction)), height(dot(normal, corner)) {}

  // Where they go toward the plane.
  PENUMBRA_INLINE Mask ahead() const { return (as_ints(cosine) ^ as_ints(height)) < Ints(0x80000000u); }
  // Where they go toward it, or start at most `back` beyond it.
  PENUMBRA_INLINE Mask ahead_from(Floats back) const { return ahead() | (abs(height) <= back * abs(cosine)); }
  PENUMBRA_INLINE Floats distance() const { return height / cosine; }
  // Where the distance has few digits.
  PENUMBRA_INLINE Mask grazing(Float3 direction) const {
    return cosine * cosine < Floats(1e-4f) * dot(direction, direction);
  }
};

// A triangle, its corners relative to the origin of the rays.
struct SeenTriangle {
  Float3 a, b, c;
  SeenPlane plane;
};

template <int axis>
PENUMBRA_INLINE Crossing cross_triangle_along(const SeenTriangle& triangle, Float3 direction, Floats nearest,
                                              const RayShear& shear) {
  const RayShear::Projected pa = shear.project<axis>(triangle.a);
  const RayShear::Projected pb = shear.project<axis>(triangle.b);
  const RayShear::Projected pc = shear.project<axis>(triangle.c);
  const Floats u = pc.x * pb.y - pc.y * pb.x;
  const Floats v = pa.x * pc.y - pa.y * pc.x;
  const Floats w = pb.x * pa.y - pb.y * pa.x;
  const Floats zero = Floats(0);
  const Mask all_positive = (u >= zero) & (v >= zero) & (w >= zero);
  const Mask all_negative = (u <= zero) & (v <= zero) & (w <= zero);
  const Floats determinant = u + v + w;
  const Mask inside = (all_positive | all_negative) & (determinant != zero);
  if (none(inside)) return {inside, zero, inside};

  Floats t = triangle.plane.distance();
  const Mask grazing = inside & triangle.plane.grazing(direction);
  if (any(grazing)) {
    const Floats weighted = u * pa.distance(shear) + v * pb.distance(shear) + w * pc.distance(shear);
    t = select(grazing, weighted / determinant, t);
  }
  return {inside & (t > nearest), t, triangle.plane.cosine > zero};
}

PENUMBRA_INLINE Crossing cross_triangle(const SeenTriangle& triangle, Float3 direction, Floats nearest,
                                        const RayShear& shear) {
  switch (shear.agreed_axis) {
    case 0:
      return cross_triangle_along<0>(triangle, direction, nearest, shear);
    case 1:
      return cross_triangle_along<1>(triangle, direction, nearest, shear);
    case 2:
      return cross_triangle_along<2>(triangle, direction, nearest, shear);
    default:
      return cross_triangle_along<-1>(triangle, direction, nearest, shear);
  }
}

PENUMBRA_INLINE SurfacePoint surface_at(const LeafTriangle& triangle, const ShapeRays& rays, Floats distance) {
  const Float3 normal = broadcast3(triangle.normal);
  const Float3 point = rays.at(distance);
  return {point - normal * dot(normal, point - broadcast3(triangle.a)), normal};
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
