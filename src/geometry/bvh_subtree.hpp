// What one thread does for the hierarchy: it builds the subtree over a range of the items, depth first.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/bvh_bins.hpp"
#include "geometry/bvh_item.hpp"
#include "geometry/world.hpp"

namespace penumbra {

// From this depth on ranges are halved, so that 2^26 items still end above depth 60.
inline constexpr int balanced_below_depth = 36;

// Items that follow each other, and where they and their doubled centres are.
struct BvhRange {
  std::uint32_t begin, end;
  int depth;  // of the node that splits it
  FloatBounds bounds, centers;

  std::uint32_t count() const { return end - begin; }
};

struct Halves {
  BvhRange left, right;
};

// The sides of a range that is split there.
inline Halves halves_of(const BvhRange& range, std::uint32_t middle, const BinnedSplit& split) {
  return {{range.begin, middle, range.depth + 1, split.left, {}},
          {middle, range.end, range.depth + 1, split.right, {}}};
}

// Where the items of either side go.
struct Sides {
  BvhItem* left;
  BvhItem* right;
};

// Copies the items to their side of a split, in their order, and tells where the centres of both are. Afterwards `to`
// is behind the copies. The left side may be where the items are.
std::array<FloatBounds, 2> deal(std::span<const BvhItem> items, const BinGrid& grid, const BinnedSplit& split,
                                Sides& to);

// A node whose children have these bounds.
Node node_with(const FloatBounds& left, const FloatBounds& right);

// What a subtree becomes: nodes, and the order of its items.
struct BvhOutput {
  Node* nodes = nullptr;           // room for as many as it has items
  std::uint32_t count = 0;         // of nodes so far
  std::uint32_t first_node = 0;    // the number of nodes[0]
  std::uint32_t* order = nullptr;  // as Bvh::order, of the whole group
  std::uint32_t first_leaf = 0;    // of the group

  // Appends a node and returns its place in `nodes`.
  std::uint32_t add(const Node& node) {
    nodes[count] = node;
    return count++;
  }
};

// Builds the subtree over a range of `items`, which are reordered; `spare` has room for as many.
NodeReference build_subtree(BvhItem* items, BvhItem* spare, const BvhRange& range, BvhOutput& output);

}  // namespace penumbra
