// A light of the frame, and the list of the kinds. What is to be known of a kind is in a file of its own in
// tracing/lights/: its numbers in single precision, relative to the origin of the frame (frame_light), whether it has
// an area, the point of it that two random numbers choose (point_on), and what that sends to a point (radiance); these
// two take the numbers of a light through `read`, so that they serve for one light in all lanes, and for one in each.
// The points of a light that has an area are center + s u + t v with |s| and |t| at most 1.
#pragma once

#include <cstdint>
#include <vector>

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

// Calls `visit` with the light as one of that kind.
template <typename Visit>
[[gnu::always_inline]] inline auto with_light(const FrameLight& light, LightKind kind, const Visit& visit) {
  switch (kind) {
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

template <typename Visit>
[[gnu::always_inline]] inline auto with_light(const FrameLight& light, const Visit& visit) {
  return with_light(light, light.kind, visit);
}

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

struct LightSample {
  Float3 toward;  // unit vector from the hit to the point on the light
  Floats distance;
  Float3 radiance;
};

// Reads the numbers of one light, for all lanes.
struct LightOfAll {
  PENUMBRA_INLINE Float3 operator()(const float (&v)[3]) const { return broadcast3(v); }
  PENUMBRA_INLINE Floats operator()(const float& v) const { return Floats(v); }
};

// Reads the numbers of the light of each lane, given those of the first light.
struct LightOfLane {
  Ints words;  // from the first light to that of the lane

  PENUMBRA_INLINE explicit LightOfLane(Ints number) : words(number * Ints(sizeof(FrameLight) / 4)) {}
  PENUMBRA_INLINE Float3 operator()(const float (&v)[3]) const {
    return {gather(&v[0], words), gather(&v[1], words), gather(&v[2], words)};
  }
  PENUMBRA_INLINE Floats operator()(const float& v) const { return gather(&v, words); }
};

// A point of the light and what shines from there: no falloff with distance, no cosine at the light.
PENUMBRA_INLINE LightSample sample_light(const FrameLight& light, LightKind kind, const auto& read, Float3 from,
                                         Pair random) {
  const auto point = [&](const auto& l) __attribute__((always_inline)) { return point_on(l, read, random); };
  LightSample sample;
  const Float3 way = with_light(light, kind, point) - from;
  sample.distance = sqrt(dot(way, way));
  sample.toward = way * (Floats(1) / sample.distance);
  const auto shine = [&](const auto& l) __attribute__((always_inline)) {
    return radiance(l, read, read(light.color), sample.toward);
  };
  sample.radiance = with_light(light, kind, shine);
  return sample;
}
PENUMBRA_INLINE LightSample sample_light(const FrameLight& light, Float3 from, Pair random) {
  return sample_light(light, light.kind, LightOfAll(), from, random);
}

// The same for a light of its own in each lane.
inline LightSample sample_lights(const std::vector<FrameLight>& lights, Ints number, Float3 from, Pair random,
                                 Mask active) {
  const LightOfLane read(number);
  const Ints kinds = gather(reinterpret_cast<const std::uint32_t*>(lights.data()), read.words) & Ints(0xffu);
  LightSample sample;
  Mask open = active;
  while (any(open)) {
    alignas(64) std::uint32_t kind_of_lane[lane_count];
    store(kind_of_lane, kinds);
    const std::uint32_t kind = kind_of_lane[__builtin_ctz(bits(open))];
    const Mask same = open & (kinds == Ints(kind));
    const LightSample some = sample_light(lights.front(), static_cast<LightKind>(kind), read, from, random);
    if (bits(same) == bits(active)) return some;
    sample.toward = select(same, some.toward, sample.toward);
    sample.distance = select(same, some.distance, sample.distance);
    sample.radiance = select(same, some.radiance, sample.radiance);
    open = open & ~same;
  }
  return sample;
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
