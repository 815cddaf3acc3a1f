// Steps 1 to 3 of Cook's loop: where in the pixel, when, and from where on the lens a ray starts.
#pragma once

#include "geometry/rays.hpp"
#include "sampling/sampler.hpp"
#include "sampling/warp.hpp"
#include "tracing/cone_lens.hpp"
#include "tracing/frame.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The eye rays of the samples, through the pixels at (column, row).
PENUMBRA_INLINE Rays eye_rays(const Frame& frame, const Sampler& sampler, Floats column, Floats row, Mask active) {
  const FrameCamera& camera = frame.camera;
  Floats x = column + Floats(camera.pixel_offset);
  Floats y = row + Floats(camera.pixel_offset);
  if (camera.pixel_width != 0) {
    const Pair place = sampler.pixel_place();
    if (frame.filter == PixelFilter::box) {
      x += place.u;
      y += place.v;
    } else {
      x += filtered_offset(frame.filter_steps, place.u) + Floats(0.5f);
      y += filtered_offset(frame.filter_steps, place.v) + Floats(0.5f);
    }
  }
  Rays rays;
  rays.coherent = true;
  rays.origin = broadcast3(camera.eye);
  rays.direction = broadcast3(camera.per_x) * x + broadcast3(camera.per_y) * y + broadcast3(camera.corner);
  rays.time = Floats(camera.shutter_open);
  if (camera.shutter_length != 0) rays.time += Floats(camera.shutter_length) * sampler.time();
  if (camera.has_lens) {
    const DiskPoint lens = warp_to_disk(sampler.lens_place());
    const Float3 offset = broadcast3(camera.lens_u) * lens.x + broadcast3(camera.lens_v) * lens.y;
    if (frame.settings.lens_model == LensModel::cone) {
      rays.direction = normalize(rays.direction);
      rays.direction = cone_direction(frame, rays, offset, active);
    } else {
      // All rays of the sample's place in the pixel meet in one point of the plane in focus.
      const Floats to_plane = Floats(camera.focus_distance) / dot(rays.direction, broadcast3(camera.view));
      const Float3 focus = rays.direction * to_plane;
      rays.origin = rays.origin + offset;
      rays.direction = focus - offset;
    }
  }
  rays.direction = normalize(rays.direction);
  return rays;
}

}  // namespace penumbra::PENUMBRA_KERNEL
