// Builds the binary bounding volume hierarchy of one group by the surface area heuristic (MacDonald and Booth 1990):
// a full sweep over few items, 32 bins over many (Wald 2007).
#pragma once

#include <cstdint>
#include <span>

#include "geometry/bounds.hpp"
#include "geometry/world.hpp"

namespace penumbra {

struct BvhItem {
  Bounds bounds;
  std::uint32_t leaf = 0;  // index of the item for the caller
  float cost = 1;          // of testing it, in tests of a sphere
};

// Reorders `items` so that every leaf of the tree is a run of them, appends the inner nodes to `nodes`, and returns the
// root. Runs count from `first_leaf`. The tree is never deeper than 60. Bounds are rounded outward.
NodeReference build_bvh(std::span<BvhItem> items, std::uint32_t first_leaf, ZeroedVector<Node>& nodes);

}  // namespace penumbra
