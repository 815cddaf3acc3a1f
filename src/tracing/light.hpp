// A point on each light, and what shines from there: no falloff with distance, no cosine at the light.
#pragma once

#include "sampling/sampler.hpp"
#include "sampling/warp.hpp"
#include "tracing/frame.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct LightSample {
  Float3 toward;  // unit vector from the hit to the point on the light
  Floats distance;
  Float3 radiance;
};

// `random` is used by disk lights only: uniform over the area.
PENUMBRA_INLINE LightSample sample_light(const FrameLight& light, Float3 from, Pair random) {
  Float3 point = broadcast3(light.position);
  if (light.kind == LightKind::disk) {
    const DiskPoint disk = warp_to_disk(random);
    point = point + broadcast3(light.disk_u) * disk.x + broadcast3(light.disk_v) * disk.y;
  }
  LightSample sample;
  const Float3 way = point - from;
  sample.distance = sqrt(dot(way, way));
  sample.toward = way * (Floats(1) / sample.distance);
  sample.radiance = broadcast3(light.color);
  if (light.kind == LightKind::spot) {
    const Floats cosine = -dot(sample.toward, broadcast3(light.axis));
    const Floats outer = Floats(light.cosine_outer);
    const Floats width = Floats(light.cosine_inner) - outer;
    const Floats t = min(max((cosine - outer) / max(width, Floats(1e-12f)), Floats(0)), Floats(1));
    const Floats smooth = t * t * (Floats(3) - Floats(2) * t);
    sample.radiance *= keep(cosine >= outer, smooth);
  }
  return sample;
}

}  // namespace penumbra::PENUMBRA_KERNEL
