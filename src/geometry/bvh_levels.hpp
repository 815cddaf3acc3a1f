// The upper levels of a hierarchy over many items, which all threads split together: a level is cut into pieces of its
// ranges, each binned and then dealt to its sides by one thread. Where an item goes depends on no other piece, so the
// order of the pieces, and of the items in them, stays that of the first.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bvh_subtree.hpp"

namespace penumbra {

// A range that is small enough for one thread.
struct Subtree {
  BvhRange range;
  std::uint32_t parent;  // in UpperLevels::nodes, and which of its children this is; if there is none, it is the root
  int side;
  BvhItem* items;  // the array that has its items, and the one that has room for them
  BvhItem* spare;
};

struct UpperLevels {
  std::vector<Node> nodes;        // level by level; children that are subtrees are not set
  std::vector<Subtree> subtrees;  // in the order of their items
  FloatBounds bounds;             // of all items
};

// Splits the items until no range is larger than a thread should take, into `items` or `spare`, which is as long.
UpperLevels split_upper_levels(std::span<BvhItem> items, std::span<BvhItem> spare, int threads);

}  // namespace penumbra
