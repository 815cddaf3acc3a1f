// Triangles whose corners have normals: between the corners, these are interpolated (Phong 1975). With them comes the
// place from which shadow rays start: off the flat triangle, on the curved surface that the tangent planes of the
// corners suggest (Hanika, Hacking the Shadow Terminator, Ray Tracing Gems II, 2021). A flat triangle would shade
// itself, and its neighbours, where the curved surface is still in the light.
#pragma once

#include "geometry/shapes/shape.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct SmoothPoint {
  Float3 normal;  // unit length, for the side that the ray comes from
  Float3 lift;    // from the point on the triangle to the curved surface; zero where that bends inwards
};

struct Corner {
  Float3 point, normal;
};

// `point` is on the triangle, whose unit normal is `flat`. Which way round the corners run says nothing here: normals
// that point to the other side of the triangle are turned, all three together.
PENUMBRA_INLINE SmoothPoint smooth_at(const Corner (&corner)[3], Float3 point, Float3 flat, Float3 direction) {
  Float3 to[3];
  for (int k = 0; k < 3; k++) to[k] = corner[k].point - point;
  Floats weight[3], sum = Floats(0);
  for (int k = 0; k < 3; k++) {
    weight[k] = max(dot(flat, cross(to[(k + 1) % 3], to[(k + 2) % 3])), Floats(0));
    sum = sum + weight[k];
  }
  const Floats one = Floats(1);
  const Float3 facing = flat * copysign(one, -dot(flat, direction));
  const Floats turn = copysign(one, dot(corner[0].normal + corner[1].normal + corner[2].normal, facing));
  const Floats scale = turn / max(sum, Floats(1e-37f));
  const Floats zero = Floats(0);
  Float3 normal{zero, zero, zero}, lift{zero, zero, zero};
  for (int k = 0; k < 3; k++) {
    const Float3 n = corner[k].normal * (weight[k] * scale);
    normal += n;
    lift += n * max(dot(to[k], corner[k].normal) * turn, zero);
  }
  const Floats size2 = dot(normal, normal);
  return {select(size2 > Floats(1e-12f), normal * (one / sqrt(size2)), facing), lift};
}

}  // namespace penumbra::PENUMBRA_KERNEL
