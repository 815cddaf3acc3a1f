// What the file of each shape builds on. It holds
//   LeafX               the numbers of the shape in single precision, as packets read them
//   leaf_of, bounds_of  these and the bounds, of the shape as the scene has it
//   mapped              the same shape under a map, where that keeps it of its kind
//   first_crossing      where W rays meet it first
//   surface_at          what it is like there
#pragma once

#include <optional>

#include "geometry/bounds.hpp"
#include "geometry/maps.hpp"
#include "scene/scene.hpp"

namespace penumbra {

// The bounds under a map, for shapes that know no tighter ones.
template <AnalyticShape Shape>
Bounds transformed_bounds(const Affine& m, const Shape& shape) {
  return transform(m, bounds_of(shape));
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
#include "base/lane_math.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The rays of a packet in the space of one shape.
struct ShapeRays {
  Float3 origin, direction;
  Floats nearest;  // hits at this distance or nearer do not count
  bool unit;       // the directions have length one
  Mask inside;     // start on this shape and go into it: only where they leave it counts

  PENUMBRA_INLINE Float3 at(Floats distance) const { return origin + direction * distance; }
};

// The smallest distance beyond `nearest`, for the lanes that hit.
struct Crossing {
  Mask hit;
  Floats distance;
  Mask leaving;  // from behind the surface
};

struct SurfacePoint {
  Float3 point;   // put back on the exact surface
  Float3 normal;  // outward, unit length
};

struct Interval {
  Floats enter, leave;
};

// The nearer end of what the rays have in common with a solid. Rays that start on it and go into it leave it, whatever
// rounding makes of a ray along its surface.
PENUMBRA_INLINE Crossing first_beyond(const ShapeRays& rays, Mask meets, Interval common) {
  const Mask leaving = ~(common.enter > rays.nearest) | rays.inside;
  const Floats t = select(leaving, common.leave, common.enter);
  return {(meets & (t > rays.nearest)) | rays.inside, t, leaving};
}

// Never zero, so that no distance to a plane is ever not a number.
PENUMBRA_INLINE Floats divisor(Floats x) { return copysign(max(abs(x), Floats(1e-30f)), x); }
PENUMBRA_INLINE Float3 divisor(Float3 d) { return {divisor(d.x), divisor(d.y), divisor(d.z)}; }

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
