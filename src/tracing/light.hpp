// A light of the frame, and the list of the kinds. What is to be known of a kind is in a file of its own in
// tracing/lights/: its numbers in single precision, relative to the origin of the frame (frame_light), whether it has
// an area, the point of it that two random numbers choose (point_on), and what that sends to a point (radiance). The
// points of a light that has an area are center + s u + t v with |s| and |t| at most 1.
#pragma once

#include <cstdint>

#ifdef PENUMBRA_LANES
#include "sampling/sampler.hpp"
#endif
#include "tracing/lights/disk.hpp"
#include "tracing/lights/point.hpp"
#include "tracing/lights/quad.hpp"
#include "tracing/lights/spot.hpp"

namespace penumbra {

enum class LightKind : std::uint8_t { point, disk, quad, spot };

struct FrameLight {
  LightKind kind = LightKind::point;
  bool has_area = false;       // its points are chosen by random numbers
  bool first_of_area = false;  // the first light of the frame that has one
  float color[3] = {0, 0, 0};
  union {  // the one of `kind`
    FramePointLight point = {};
    FrameDiskLight disk;
    FrameQuadLight quad;
    FrameSpotLight spot;
  };

  void hold(const FramePointLight& l) { kind = LightKind::point, point = l; }
  void hold(const FrameDiskLight& l) { kind = LightKind::disk, disk = l; }
  void hold(const FrameQuadLight& l) { kind = LightKind::quad, quad = l; }
  void hold(const FrameSpotLight& l) { kind = LightKind::spot, spot = l; }
};

// Calls `visit` with the light as what it is.
template <typename Visit>
[[gnu::always_inline]] inline auto with_light(const FrameLight& light, const Visit& visit) {
  switch (light.kind) {
    case LightKind::point:
      return visit(light.point);
    case LightKind::disk:
      return visit(light.disk);
    case LightKind::quad:
      return visit(light.quad);
    case LightKind::spot:
      return visit(light.spot);
  }
  __builtin_unreachable();
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

struct LightSample {
  Float3 toward;  // unit vector from the hit to the point on the light
  Floats distance;
  Float3 radiance;
};

// A point of the light and what shines from there: no falloff with distance, no cosine at the light.
PENUMBRA_INLINE LightSample sample_light(const FrameLight& light, Float3 from, Pair random) {
  const auto point = [&](const auto& l) __attribute__((always_inline)) { return point_on(l, random); };
  LightSample sample;
  const Float3 way = with_light(light, point) - from;
  sample.distance = sqrt(dot(way, way));
  sample.toward = way * (Floats(1) / sample.distance);
  const auto shine = [&](const auto& l) __attribute__((always_inline)) {
    return radiance(l, broadcast3(light.color), sample.toward);
  };
  sample.radiance = with_light(light, shine);
  return sample;
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
