// What is recorded of the rays of one sample, and who receives it.
#pragma once

#include <atomic>
#include <cstdint>

#include "tracing/ray_kind.hpp"

namespace penumbra {

// One ray of a sample, as it was traced, in the space of the frame (Frame::origin).
struct RecordedRay {
  RayKind kind;
  int depth;            // 0 for the eye ray
  int parent;           // the ray whose hit sent it, by its number in the order of the records; -1 for the eye ray
  std::uint32_t count;  // one of so many rays of its kind, whose mean counts
  float origin[3], direction[3];  // the direction has length one
  float time;
  bool hit;        // whether it hit anything; of a shadow ray, whether anything is in the way
  float distance;  // to what was hit
  std::uint32_t surface;
  float point[3], normal[3];  // the normal is the one that shades
  float ambient[3];           // what the surface shines by itself
  std::uint32_t light;        // of a shadow ray
  float light_distance;       // to the point of the light
  float came_back[3];         // the colour the ray saw; of a shadow ray, the share of the light that comes through
  float factor[3];  // what that is worth where the ray was sent from; of a shadow ray known only if light came back
  float adds[3];    // of a shadow ray: what it adds there
};

// Who wants to know all rays of a sample.
struct RayListener {
  void* self;
  // Returns where to keep a new ray, in the order in which the rays are sent, or null if there is no more room. What
  // comes back is filled in later, so what was returned must stay where it is.
  RecordedRay* (*add)(void* self);
  const std::atomic<bool>* given_up = nullptr;  // once it is set, no further rays are sent
};

}  // namespace penumbra
