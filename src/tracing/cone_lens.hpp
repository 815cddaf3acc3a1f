// The lecture's first way to simulate a lens (slide 49): no lens at all, but rays from the eye that lie within a cone.
// The ray of the pinhole finds what is seen and its distance D along the view; the ray of the sample then goes through
// a point of the disk round that hit, parallel to the image plane, of radius
//
//   r = (lens radius) |D - P| / P,   and where the pinhole sees nothing, r / D = (lens radius) / P.
//
// It looks like a lens as long as everything round the hit is as far as the hit: edges before something nearer or
// farther are where "isn't very accurate" (slide 49) shows.
#pragma once

#include "geometry/traversal.hpp"
#include "tracing/frame.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The direction, of any length, of the samples whose pinhole rays are given, with unit directions and times; `offset`
// is a point of the disk of the lens, from its centre. The pinhole rays are a means and not samples: no ray count has
// them.
inline Float3 cone_direction(const Frame& frame, const Rays& pinhole, Float3 offset, Mask active) {
  const FrameCamera& camera = frame.camera;
  const Hits hits = intersect(frame.world, pinhole, Floats(__builtin_inff()), active);
  // Everything for a distance of 1 along the view.
  const Floats along_view = dot(pinhole.direction, broadcast3(camera.view));
  const Floats distance = hits.distance * along_view;
  const Floats focus = Floats(camera.focus_distance);
  const Floats spread = select(hits.found, abs(distance - focus) / (distance * focus), Floats(1) / focus);
  return pinhole.direction * (Floats(1) / along_view) + offset * spread;
}

}  // namespace penumbra::PENUMBRA_KERNEL
