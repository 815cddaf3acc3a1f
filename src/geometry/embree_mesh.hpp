// The only file pair that builds with Embree: large static triangle meshes, committed once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/embree_library.hpp"
#include "geometry/world.hpp"

namespace penumbra {

// Embree's context with what is needed to settle ties: the nearest hit so far of each ray, whose id is its lane. An
// order counts triangles in the order of the file.
struct TieContext {
  EmbreeContext context;  // first, so that Embree's pointer to it is one to all of this
  const Mesh* mesh;
  float distance[16];
  std::uint32_t order[16];
};

// A device of the given thread count, made at the first call that needs one.
class EmbreeDevice {
 public:
  explicit EmbreeDevice(int threads) : threads_(threads) {}

  // One Embree scene with a geometry for each (first triangle, count) of the store, whose buffers it shares: the store
  // must outlive it and not move. Throws std::runtime_error with Embree's own message.
  std::shared_ptr<RTCSceneTy> build(const TriangleStore& store, std::span<const TriangleRange> ranges);

 private:
  int threads_;
  std::shared_ptr<RTCDeviceTy> device_;
};

}  // namespace penumbra
