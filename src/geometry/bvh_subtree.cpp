#include "geometry/bvh_subtree.hpp"

#include <algorithm>
#include <utility>

#include "geometry/bvh_sweep.hpp"

namespace penumbra {
namespace {

struct SubtreeBuilder {
  BvhItem* all_items;
  BvhItem* spare;
  BvhOutput& output;
  Bins bins;

  NodeReference build(const BvhRange& range) {
    if (range.count() <= SweepTree::most_items) {
      return SweepTree(items_of(range), range.begin, output).build(range.depth, range.bounds);
    }
    const Halves halves = split(range);
    const std::uint32_t node = output.add(node_with(halves.left.bounds, halves.right.bounds));
    output.nodes[node].child[0] = build(halves.left);
    output.nodes[node].child[1] = build(halves.right);
    return output.first_node + node;
  }

  std::span<BvhItem> items_of(const BvhRange& range) const { return {all_items + range.begin, range.count()}; }

  Halves split(const BvhRange& range) {
    if (range.depth >= balanced_below_depth) return split_by_count(range);
    const BinGrid grid(range.centers);
    bins.clear();
    bins.add(items_of(range), grid);
    const BinnedSplit best = bins.best_split(inverse_extent(range.bounds));
    if (best.axis < 0) return split_by_count(range);
    Sides to{all_items + range.begin, spare + range.begin};
    const auto [left, right] = deal(items_of(range), grid, best, to);
    Halves halves = halves_of(range, static_cast<std::uint32_t>(to.left - all_items), best);
    std::copy_n(spare + range.begin, halves.right.count(), all_items + halves.right.begin);
    halves.left.centers = left;
    halves.right.centers = right;
    return halves;
  }

  // Halves along the longest axis of the centres.
  Halves split_by_count(const BvhRange& range) {
    const Float4 extent = range.centers.hi - range.centers.lo;
    const int axis = longest_axis(extent);
    if (extent[axis] > 0) {
      std::ranges::sort(items_of(range), {}, [axis](const BvhItem& item) {
        return std::pair(item.lo[axis] + item.hi[axis], item.leaf);  // which makes the order total
      });
    }
    Halves halves = halves_of(range, range.begin + range.count() / 2, {});
    for (BvhRange* half : {&halves.left, &halves.right}) {
      for (const BvhItem& item : items_of(*half)) {
        half->bounds.include(item.bounds());
        half->centers.include(center_of(item.bounds()));
      }
    }
    return halves;
  }
};

}  // namespace

std::array<FloatBounds, 2> deal(std::span<const BvhItem> items, const BinGrid& grid, const BinnedSplit& split,
                                Sides& to) {
  std::array<FloatBounds, 2> centers;
  for (const BvhItem& item : items) {
    const BvhItem copy = item;
    const Float4 center = center_of(copy.bounds());
    const bool right = split.goes_right(grid.bins_of(center));
    *(right ? to.right : to.left) = copy;
    to.left += !right;
    to.right += right;
    centers[right].include(center);
  }
  return centers;
}

Node node_with(const FloatBounds& left, const FloatBounds& right) {
  Node node{};
  for (int axis = 0; axis < 3; axis++) {
    node.bounds[0][axis] = left.lo[axis];
    node.bounds[0][3 + axis] = left.hi[axis];
    node.bounds[1][axis] = right.lo[axis];
    node.bounds[1][3 + axis] = right.hi[axis];
  }
  return node;
}

NodeReference build_subtree(BvhItem* items, BvhItem* spare, const BvhRange& range, BvhOutput& output) {
  return SubtreeBuilder{items, spare, output, {}}.build(range);
}

}  // namespace penumbra
