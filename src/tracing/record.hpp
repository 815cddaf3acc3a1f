// Keeps a record of all rays of one lane, for whoever asks what a pixel saw. Only recording.cpp is compiled with it; in
// the kernels that render pictures, Recorder is an empty type whose calls do nothing. What is recorded is what was
// computed for the picture, to the last bit; only what a shadow ray ran into is looked up once more.
#pragma once

#include "geometry/traversal.hpp"
#include "tracing/frame.hpp"
#include "tracing/recorded_ray.hpp"

namespace penumbra::PENUMBRA_KERNEL {

#ifdef PENUMBRA_RECORDS

PENUMBRA_INLINE float lane_of(Floats values, int lane) {
  alignas(64) float all[lane_count];
  store(all, values);
  return all[lane];
}
PENUMBRA_INLINE void lane_of(Float3 values, int lane, float (&out)[3]) {
  out[0] = lane_of(values.x, lane);
  out[1] = lane_of(values.y, lane);
  out[2] = lane_of(values.z, lane);
}

class RayRecorder {
 public:
  RayRecorder(const World& world, const RayListener& listener, int lane)
      : world_(world), listener_(listener), lane_(lane) {}

  // What the rays are that the hit at `depth` sends next.
  void announce(RayKind kind, Floats factor, std::uint32_t count, int depth) {
    open_[depth].next_kind = kind;
    open_[depth].next_factor = lane_of(factor, lane_);
    open_[depth].next_count = count;
  }

  // A ray and what it hit; `end` tells what came back. Both are called for packets without the lane, too.
  void begin(const Rays& rays, const Hits& hits, Mask active, int depth) {
    Open& open = open_[depth];
    open = {};
    if (!is_in(active)) return;
    open.number = count_++;
    open.ray = listener_.add(listener_.self);
    if (!open.ray) return;
    RecordedRay& ray = *open.ray;
    ray = {};
    ray.kind = depth == 0 ? RayKind::eye : open_[depth - 1].next_kind;
    ray.depth = depth;
    ray.parent = depth == 0 ? -1 : open_[depth - 1].number;
    ray.count = depth == 0 ? 1 : open_[depth - 1].next_count;
    for (float& f : ray.factor) f = depth == 0 ? 1 : open_[depth - 1].next_factor;
    fill_in(ray, rays, hits, is_in(hits.found));
  }
  void surface(Float3 ambient, Float3 shading, int depth) {
    RecordedRay* ray = open_[depth].ray;
    if (!ray || !ray->hit) return;
    lane_of(ambient, lane_, ray->ambient);
    lane_of(shading, lane_, ray->normal);
  }
  void end(Float3 color, int depth) {
    RecordedRay* ray = open_[depth].ray;
    if (ray) lane_of(color, lane_, ray->came_back);
  }

  // A shadow ray of any length from the hit at `depth`, for the lanes in `sent`; `lit` tells what it adds.
  void shadow(std::uint32_t light, const Rays& rays, Floats distance, Mask sent, Floats visible, int depth) {
    last_shadow_ = nullptr;
    if (!is_in(sent) || open_[depth].number < 0) return;
    count_++;
    last_shadow_ = listener_.add(listener_.self);
    if (!last_shadow_) return;
    RecordedRay& ray = *last_shadow_;
    ray = {};
    ray.kind = RayKind::shadow;
    ray.depth = depth + 1;
    ray.parent = open_[depth].number;
    ray.light = light;
    ray.count = 1;
    const float through = lane_of(visible, lane_);
    const Hits hits = intersect(world_, rays, distance, sent);
    fill_in(ray, rays, hits, through != 1 && is_in(hits.found));
    ray.light_distance = lane_of(distance, lane_);
    for (float& c : ray.came_back) c = through;
  }
  void lit(Float3 adds) {
    if (!last_shadow_) return;
    lane_of(adds, lane_, last_shadow_->adds);
    for (int c = 0; c < 3; c++) {
      const float through = last_shadow_->came_back[c];
      if (through > 0) last_shadow_->factor[c] = last_shadow_->adds[c] / through;
    }
  }

 private:
  bool is_in(Mask mask) const { return (bits(mask) >> lane_) & 1; }

  void fill_in(RecordedRay& ray, const Rays& rays, const Hits& hits, bool hit) const {
    lane_of(rays.origin, lane_, ray.origin);
    lane_of(rays.direction, lane_, ray.direction);
    ray.time = lane_of(rays.time, lane_);
    ray.hit = hit;
    if (!hit) return;
    alignas(64) std::uint32_t surfaces[lane_count];
    store(surfaces, hits.surface);
    ray.surface = surfaces[lane_];
    ray.distance = lane_of(hits.distance, lane_);
    lane_of(hits.point, lane_, ray.point);
    lane_of(hits.normal, lane_, ray.normal);
  }

  struct Open {
    int number = -1;  // of the ray of the lane that is being traced there; -1 for none
    RecordedRay* ray = nullptr;
    RayKind next_kind = RayKind::eye;
    float next_factor = 0;
    std::uint32_t next_count = 1;
  };

  const World& world_;
  const RayListener& listener_;
  int lane_;
  int count_ = 0;  // rays so far
  RecordedRay* last_shadow_ = nullptr;
  Open open_[most_depth + 1];
};
using Recorder = RayRecorder&;

#else

struct Recorder {
  void announce(const auto&...) const {}
  void begin(const auto&...) const {}
  void surface(const auto&...) const {}
  void end(const auto&...) const {}
  void shadow(const auto&...) const {}
  void lit(const auto&...) const {}
};

#endif

}  // namespace penumbra::PENUMBRA_KERNEL
