// Where rays hit surfaces: what is there, which side they came to, and how rays leave.
#pragma once

#include "tracing/leaving.hpp"
#include "tracing/material.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The normals of hits: for N.L, and on the viewer's side. Often the same.
struct Normals {
  const Float3 *shading, *facing;
};

struct Interaction {
  const Rays& rays;
  const Hits& hits;
  const Material material;
  Mask behind;  // the rays came to the side that the normal points away from
  Normals normals{&hits.normal, &hits.normal};
  RayStart start;  // of the rays that leave

  // Some lane must have hit something. It points to itself: it stays where it is made.
  PENUMBRA_INLINE Interaction(const Frame& frame, const Rays& arrived, const Hits& found)
      : rays(arrived), hits(found), material(material_at(frame, found)) {
    behind = dot(hits.normal, rays.direction) > Floats(0);
    if (rays.any_inward) behind |= rays.inward() & (hits.place == *rays.start->place);
    behind &= hits.found;
    if (any(behind)) {
      facing_ = select(behind, -hits.normal, hits.normal);
      shading_ = select(hits.two_sided, facing_, hits.normal);
      normals = {&shading_, &facing_};
    }
    if (any(hits.smooth)) {
      shading_ = select(hits.smooth, hits.smooth_normal, *normals.shading);
      normals.shading = &shading_;
    }
    start = start_at(hits, rays, material, behind);
  }
  Interaction(const Interaction&) = delete;

 private:
  Float3 facing_, shading_;
};

}  // namespace penumbra::PENUMBRA_KERNEL
