#include "geometry/bvh.hpp"

#include <algorithm>

#include "base/parallel_for.hpp"
#include "geometry/bvh_levels.hpp"

namespace penumbra {
namespace {

constexpr std::uint32_t cost_of_few = 4;  // up to here a tree costs more than it saves

Vec3 vector_of(Float4 v) { return {v[0], v[1], v[2]}; }

Bvh bvh_of_few(std::span<const BvhItem> items, std::uint32_t first_leaf) {
  Bvh bvh;
  bvh.root = leaf_reference(first_leaf, static_cast<std::uint32_t>(items.size()));
  for (const BvhItem& item : items) {
    bvh.order.push_back(item.leaf);
    bvh.bounds = include(bvh.bounds, Bounds{vector_of(item.bounds().lo), vector_of(item.bounds().hi)});
  }
  return bvh;
}

bool are_few(std::span<const BvhItem> items) {
  std::uint32_t cost = 0;
  for (const BvhItem& item : items.first(std::min<std::size_t>(items.size(), cost_of_few + 1))) cost += item.cost;
  return items.size() <= 1 || cost <= cost_of_few;
}

}  // namespace

Bvh build_bvh(ZeroedVector<BvhItem> items, std::uint32_t first_leaf, int threads, ZeroedVector<Node>& nodes) {
  if (are_few(items)) return bvh_of_few(items, first_leaf);
  ZeroedVector<BvhItem> spare;
  spare.resize(items.size());
  UpperLevels upper = split_upper_levels(items, spare, threads);

  // The nodes of a subtree begin as many places behind the upper ones as there are items before it, so that no subtree
  // waits for another one; it has fewer nodes than items, and what remains between two subtrees is not used.
  const auto first_node = static_cast<std::uint32_t>(nodes.size());
  const auto first_below = first_node + static_cast<std::uint32_t>(upper.nodes.size());
  nodes.resize(first_below + items.size());
  Bvh bvh;
  bvh.order.resize(items.size());
  std::vector<BvhOutput> outputs(upper.subtrees.size());
  std::vector<NodeReference> roots(upper.subtrees.size());
  parallel_for(upper.subtrees.size(), threads, [&](std::size_t i) {
    const Subtree& subtree = upper.subtrees[i];
    const std::uint32_t first = first_below + subtree.range.begin;
    outputs[i] = {nodes.data() + first, 0, first, bvh.order.data(), first_leaf};
    roots[i] = build_subtree(subtree.items, subtree.spare, subtree.range, outputs[i]);
  });
  nodes.resize(outputs.back().first_node + outputs.back().count);

  for (Node& node : upper.nodes) {
    for (NodeReference& child : node.child) child += first_node;
  }
  bvh.root = upper.nodes.empty() ? roots.front() : first_node;
  for (std::size_t i = 0; i < roots.size() && !upper.nodes.empty(); i++) {
    upper.nodes[upper.subtrees[i].parent].child[upper.subtrees[i].side] = roots[i];
  }
  std::ranges::copy(upper.nodes, nodes.begin() + first_node);
  bvh.bounds = {vector_of(upper.bounds.lo), vector_of(upper.bounds.hi)};
  return bvh;
}

}  // namespace penumbra
