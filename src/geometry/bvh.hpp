// Builds the binary bounding volume hierarchy of one group by the surface area heuristic: many items are split between
// bins (bvh_bins.hpp), few by a full sweep (bvh_sweep.hpp). All threads split the upper levels together
// (bvh_levels.hpp) and then take the subtrees below by turns (bvh_subtree.hpp). The tree does not depend on their
// number.
#pragma once

#include <cstdint>

#include "geometry/bounds.hpp"
#include "geometry/bvh_item.hpp"
#include "geometry/world.hpp"

namespace penumbra {

struct Bvh {
  NodeReference root = leaf_reference(0, 0);
  ZeroedVector<std::uint32_t> order;  // the items in the order of the tree, by their index `leaf`
  Bounds bounds;                      // of all items
};

// Finds an order of the items in which every leaf of the tree is a run of them, and appends the inner nodes to `nodes`.
// Runs count from `first_leaf`. The tree is never deeper than 60. Starts threads only for more than 2^14 items.
Bvh build_bvh(ZeroedVector<BvhItem> items, std::uint32_t first_leaf, int threads, ZeroedVector<Node>& nodes);

}  // namespace penumbra
