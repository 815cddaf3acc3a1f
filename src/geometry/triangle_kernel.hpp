// Where W rays meet one triangle, without gaps along shared edges and corners: the corners are projected along the ray
// to a plane, each by the same arithmetic whatever triangle it belongs to, and the signs of the edge functions of the
// projected corners are never wrong, only sometimes zero, which counts as inside (Woop, Benthin and Wald 2013).
// The distance is that of the triangle's plane, so that triangles of one axis-aligned plane tie exactly.
#pragma once

#include "geometry/shape_kernels.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The shear that turns the ray's direction into its largest axis, as three rows.
struct RayShear {
  Float3 row_x, row_y, row_z;
  Floats slope_x, slope_y;  // minus the other two axes per largest
  int agreed_axis = -1;     // the largest axis, where all rays of a packet agree on it

  PENUMBRA_INLINE RayShear() = default;
  PENUMBRA_INLINE RayShear(Float3 d, Mask active) {
    const Float3 size{abs(d.x), abs(d.y), abs(d.z)};
    const Mask z_largest = (size.z >= size.x) & (size.z >= size.y);
    const Mask y_largest = ~z_largest & (size.y >= size.x);
    const Floats zero = Floats(0);
    const Floats one = Floats(1);
    // The two other axes follow the largest cyclically.
    const Floats along = select(z_largest, d.z, select(y_largest, d.y, d.x));
    const Floats next = select(z_largest, d.x, select(y_largest, d.z, d.y));
    const Floats last = select(z_largest, d.y, select(y_largest, d.x, d.z));
    const Floats inverse = one / along;
    slope_x = -(next * inverse);
    slope_y = -(last * inverse);
    const std::uint32_t all = bits(active);
    if ((bits(z_largest) & all) == all) agreed_axis = 2;
    if ((bits(y_largest) & all) == all) agreed_axis = 1;
    if ((bits(z_largest | y_largest) & all) == 0) agreed_axis = 0;
    const auto row = [&](Floats on_next, Floats on_last, Floats on_largest) {
      return Float3{select(z_largest, on_next, select(y_largest, on_last, on_largest)),
                    select(z_largest, on_last, select(y_largest, on_largest, on_next)),
                    select(z_largest, on_largest, select(y_largest, on_next, on_last))};
    };
    row_x = row(one, zero, slope_x);
    row_y = row(zero, one, slope_y);
    row_z = row(zero, zero, inverse);
  }

  struct Projected {
    Floats x, y;
  };
  // A corner, relative to the origin, as the ray sees it. Both ways give the same bits: the rows hold exact ones and
  // zeros besides the slope.
  PENUMBRA_INLINE Projected project(Float3 corner) const {
    switch (agreed_axis) {
      case 0:
        return {corner.y + corner.x * slope_x, corner.z + corner.x * slope_y};
      case 1:
        return {corner.z + corner.y * slope_x, corner.x + corner.y * slope_y};
      case 2:
        return {corner.x + corner.z * slope_x, corner.y + corner.z * slope_y};
      default:
        return {dot(corner, row_x), dot(corner, row_y)};
    }
  }
};

// corners a, b, c relative to the ray's origin.
PENUMBRA_INLINE Crossing cross_triangle(Float3 a, Float3 b, Float3 c, Float3 normal, Float3 direction, Floats nearest,
                                        const RayShear& shear) {
  const RayShear::Projected pa = shear.project(a), pb = shear.project(b), pc = shear.project(c);
  const Floats u = pc.x * pb.y - pc.y * pb.x;
  const Floats v = pa.x * pc.y - pa.y * pc.x;
  const Floats w = pb.x * pa.y - pb.y * pa.x;
  const Floats zero = Floats(0);
  const Mask all_positive = (u >= zero) & (v >= zero) & (w >= zero);
  const Mask all_negative = (u <= zero) & (v <= zero) & (w <= zero);
  const Floats determinant = u + v + w;
  const Mask inside = (all_positive | all_negative) & (determinant != zero);
  if (none(inside)) return {inside, zero};

  const Floats cosine = dot(normal, direction);
  Floats t = dot(normal, a) / cosine;
  const Mask grazing = inside & (cosine * cosine < Floats(1e-4f) * dot(direction, direction));
  if (any(grazing)) {
    const Floats weighted = u * dot(a, shear.row_z) + v * dot(b, shear.row_z) + w * dot(c, shear.row_z);
    t = select(grazing, weighted / determinant, t);
  }
  return {inside & (t > nearest), t};
}

}  // namespace penumbra::PENUMBRA_KERNEL
