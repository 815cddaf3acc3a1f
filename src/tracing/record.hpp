// Keeps a record of all rays of one lane, for whoever asks what a pixel saw. Only recording.cpp is compiled with it; in
// the kernels that render pictures, Recorder is an empty type whose calls do nothing. What is recorded is what was
// computed for the picture, to the last bit; only what a shadow ray ran into is looked up once more.
#pragma once

#include <algorithm>
#include <array>

#include "geometry/traversal.hpp"
#include "tracing/frame.hpp"
#include "tracing/recorded_ray.hpp"

namespace penumbra::PENUMBRA_KERNEL {

#ifdef PENUMBRA_RECORDS

inline constexpr bool records = true;

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
  // `adds_up`: what a ray saw is the sum of what was recorded below it. Else it is what the packet computed: that is
  // the same, unless some rays go on alone, whose light goes straight to the sample.
  RayRecorder(const World& world, const RayListener& listener, int lane, bool adds_up)
      : world_(world), listener_(listener), lane_(lane), adds_up_(adds_up) {}

  // What the rays are that the hit at `depth` sends next: transmitted where `through`, else reflected.
  void announce(Mask through, Floats factor, std::uint32_t count, int depth) {
    Open& open = open_[depth];
    open.next_kind = is_in(through) ? RayKind::transmission : RayKind::reflection;
    open.below[index_of(open.next_kind)].factor = lane_of(factor, lane_);
    open.below[index_of(open.next_kind)].count = count;
  }

  // A ray and what it hit; `end` tells what came back. Both are called for packets without the lane, too.
  void begin(const Rays& rays, const Hits& hits, Mask active, int depth) {
    Open& open = open_[depth];
    open = {};
    if (!is_in(active)) return;
    open.number = count_++;
    open.hit = is_in(hits.found);
    open.ray = listener_.add(listener_.self);
    if (!open.ray) return;
    RecordedRay& ray = *open.ray;
    ray = {};
    ray.kind = kind_at(depth);
    ray.depth = depth;
    ray.parent = depth == 0 ? -1 : open_[depth - 1].number;
    ray.count = depth == 0 ? 1 : of_kind(depth).count;
    for (float& f : ray.factor) f = depth == 0 ? 1 : of_kind(depth).factor;
    fill_in(ray, rays, hits, open.hit);
  }
  void surface(Float3 ambient, Float3 shading, int depth) {
    Open& open = open_[depth];
    if (open.number < 0 || !open.hit) return;
    lane_of(ambient, lane_, open.ambient);
    if (!open.ray) return;
    lane_of(ambient, lane_, open.ray->ambient);
    lane_of(shading, lane_, open.ray->normal);
  }
  void end(Float3 color, int depth) {
    Open& open = open_[depth];
    if (open.number < 0) return;
    float came_back[3];
    lane_of(color, lane_, came_back);
    if (adds_up_ && open.hit) open.add_up(came_back);
    if (open.ray) std::copy_n(came_back, 3, open.ray->came_back);
    if (depth == 0) return;
    for (int c = 0; c < 3; c++) of_kind(depth).sum[c] += came_back[c];
  }

  // The colours of the samples.
  void samples(Float3 color) { lane_of(color, lane_, color_); }
  std::array<float, 3> color() const { return {color_[0], color_[1], color_[2]}; }

  // A shadow ray of any length from the hit at `depth`, for the lanes in `sent`; `lit` tells what it adds.
  void shadow(Ints light, const Rays& rays, Floats distance, Mask sent, Floats visible, int depth) {
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
    alignas(64) std::uint32_t lights[lane_count];
    store(lights, light);
    ray.light = lights[lane_];
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
    for (int c = 0; c < 3; c++) open_[last_shadow_->depth - 1].direct[c] += last_shadow_->adds[c];
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

  static constexpr std::size_t index_of(RayKind kind) { return static_cast<std::size_t>(kind); }

  // The rays of one kind that a hit sent, and the sum of what they saw.
  struct Below {
    float factor = 0;
    std::uint32_t count = 1;
    float sum[3] = {0, 0, 0};
  };

  // The ray of the lane that is being traced at a depth.
  struct Open {
    int number = -1;  // -1: there is none
    bool hit = false;
    RecordedRay* ray = nullptr;
    float ambient[3] = {0, 0, 0}, direct[3] = {0, 0, 0};
    RayKind next_kind = RayKind::eye;
    Below below[ray_kind_count];

    // In the order of sum_of (rendering/ray_tree.cpp).
    void add_up(float (&sum)[3]) const {
      for (int c = 0; c < 3; c++) {
        float indirect = 0;
        for (const Below& b : below) indirect += b.sum[c] * (1.0f / static_cast<float>(b.count)) * b.factor;
        sum[c] = (ambient[c] + direct[c]) + indirect;
      }
    }
  };
  RayKind kind_at(int depth) const { return depth == 0 ? RayKind::eye : open_[depth - 1].next_kind; }
  Below& of_kind(int depth) { return open_[depth - 1].below[index_of(kind_at(depth))]; }

  const World& world_;
  const RayListener& listener_;
  int lane_;
  bool adds_up_;
  int count_ = 0;  // rays so far
  float color_[3] = {0, 0, 0};
  RecordedRay* last_shadow_ = nullptr;
  Open open_[most_depth + 1];
};
using Recorder = RayRecorder&;

#else

inline constexpr bool records = false;

struct Recorder {
  void announce(const auto&...) const {}
  void begin(const auto&...) const {}
  void surface(const auto&...) const {}
  void end(const auto&...) const {}
  void samples(const auto&...) const {}
  void shadow(const auto&...) const {}
  void lit(const auto&...) const {}
};

#endif

}  // namespace penumbra::PENUMBRA_KERNEL
