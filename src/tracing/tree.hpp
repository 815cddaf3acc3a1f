// The tree of rays that a sample is: where in it a ray is, and how many rays its hit sends.
#pragma once

#include "sampling/lone_sampler.hpp"
#include "sampling/sampler.hpp"
#include "tracing/frame.hpp"
#include "tracing/ray_kind.hpp"
#include "tracing/record.hpp"

namespace penumbra::PENUMBRA_KERNEL {

class LoneRays;

struct TraceContext {
  const Frame& frame;
  const Sampler& sampler;
  RayCounts& counts;
  LoneRays& lone_rays;                // those that go on alone (tracing/lone_rays.hpp)
  const std::atomic<bool>* given_up;  // Rays::given_up
  [[no_unique_address]] Recorder recorder;
};

// The place of a ray in its tree, as a hash; the eye ray's is the root.
using TreePlace = std::uint32_t;
inline constexpr TreePlace tree_root = 0x1b873593u;
enum TreeStep : std::uint32_t {
  step_reflection = 1,
  step_transmission = 2,
  step_gloss = 3,
  step_choice = 4,
  step_blur = 5,
  step_chosen = 6,
  step_clusters = 7,
  step_light = 8
};
PENUMBRA_INLINE TreePlace step(TreePlace place, std::uint32_t number) { return hash(place, number); }
PENUMBRA_INLINE Ints step(Ints place, std::uint32_t number) { return hash(place, Ints(number)); }

// Where in its tree the ray of every lane is.
struct TreeNode {
  int depth = 0;  // of the eye ray
  TreePlace place = tree_root;
  Floats weight{1.0f};  // what a ray is worth in its sample; where the frame chooses branches

  PENUMBRA_INLINE bool is_root() const { return place == tree_root; }
};

// Where rays are that go on alone, each in a place of its own.
struct LoneNode {
  LoneSampler sampler;
  Ints place;
  Ints deep;  // the depth of each ray
  int depth;  // the same, where it is that of all of them: only then rays are recorded
  Floats weight;
  Ints slot;  // of its sample in LoneRays

  static constexpr bool is_root() { return false; }
};

// One ray of the several that the hit of an eye ray may send.
struct RayOfHit {
  std::uint32_t number, count;
};

// How many rays a hit sends: those of the first hit are set by the picture, deeper ones send one.
PENUMBRA_INLINE std::uint32_t rays_of_hit(int rays_of_first, const auto& node) {
  return node.is_root() ? static_cast<std::uint32_t>(rays_of_first) : 1;
}

}  // namespace penumbra::PENUMBRA_KERNEL
