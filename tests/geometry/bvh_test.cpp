// The tree over the bounds of a group's leaves: nothing is lost, every node's bounds hold what is below it, and no
// input makes it deeper than the traversal has stack for.
#include "geometry/bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/test_scale.hpp"
#include "geometry/random_scene.hpp"

namespace penumbra::test {
namespace {

constexpr std::uint32_t first_leaf = 17;  // of the group, in the world
constexpr int deepest = 60;

struct Walk {
  const std::vector<BvhItem>& items;
  const ZeroedVector<Node>& nodes;
  std::vector<int> seen;
  int depth = 0;

  Bounds visit(NodeReference node, int level) {
    depth = std::max(depth, level);
    Bounds bounds;
    if (is_leaf(node)) {
      EXPECT_LE(leaf_count(node), max_leaves_in_node);
      for (std::uint32_t i = leaf_first(node); i < leaf_first(node) + leaf_count(node); i++) {
        seen.at(i - first_leaf)++;
        bounds = include(bounds, items.at(i - first_leaf).bounds);
      }
      return bounds;
    }
    for (int child = 0; child < 2; child++) {
      const Bounds below = visit(nodes.at(node).child[child], level + 1);
      const float* stored = nodes[node].bounds[child];
      int outside = 0;
      for (int axis = 0; axis < 3; axis++)
        outside += stored[axis] > below.lo[axis] || stored[3 + axis] < below.hi[axis];
      EXPECT_EQ(outside, 0);
      bounds = include(bounds, below);
    }
    return bounds;
  }
};

// Builds the tree, checks it, and returns its depth.
int checked_depth(std::vector<BvhItem> items) {
  for (std::size_t i = 0; i < items.size(); i++) items[i].leaf = static_cast<std::uint32_t>(i);
  const std::vector<BvhItem> before = items;
  ZeroedVector<Node> nodes(3);  // of another group
  const NodeReference root = build_bvh(items, first_leaf, nodes);
  Walk walk{items, nodes, std::vector<int>(items.size()), 0};
  walk.visit(root, 0);
  EXPECT_EQ(std::count(walk.seen.begin(), walk.seen.end(), 1), static_cast<std::ptrdiff_t>(items.size()));
  std::vector<int> kept(items.size());
  for (const BvhItem& item : items) {
    kept.at(item.leaf)++;
    EXPECT_EQ(item.bounds.lo, before[item.leaf].bounds.lo);
  }
  EXPECT_EQ(std::count(kept.begin(), kept.end(), 1), static_cast<std::ptrdiff_t>(items.size()));
  return walk.depth;
}

Bounds box_at(Vec3 p, double size) { return grow({p, p}, size); }

TEST(Bvh, HoldsEveryItemOfRandomInput) {
  Random random(1);
  for (const int count : {0, 1, 2, 3, 8, 9, 31, 32, 500, 513, scaled(20000, 2000)}) {
    std::vector<BvhItem> items;
    for (int i = 0; i < count; i++) {
      items.push_back({box_at(random_point(random, 10), std::exp(uniform(random, -6, 1))), 0,
                       static_cast<float>(uniform(random, 1, 16))});
    }
    EXPECT_LE(checked_depth(items), 40) << count;
  }
}

TEST(Bvh, ItemsAtTheSamePlace) {
  const auto count = static_cast<std::size_t>(scaled(100000, 10000));
  EXPECT_LE(checked_depth(std::vector<BvhItem>(count, {box_at({1, 2, 3}, 1), 0, 1})), deepest);
  EXPECT_LE(checked_depth(std::vector<BvhItem>(count, {box_at({1, 2, 3}, 0), 0, 1})), deepest);
}

TEST(Bvh, ExponentiallyGrowingPositions) {
  std::vector<BvhItem> items;
  const int count = scaled(100000, 10000);
  for (int i = 0; i < count; i++) {
    const double x = std::exp2(-100 + 200.0 * i / count);
    items.push_back({box_at({x, 0, 0}, x * 1e-7), 0, 1});
  }
  EXPECT_LE(checked_depth(items), deepest);
  // One far from the next by a factor of two, in all three axes by turns.
  items.clear();
  for (int i = 0; i < 250; i++) {
    Vec3 p;
    p[i % 3] = std::exp2(i - 125);
    for (int k = 0; k < 20; k++) items.push_back({box_at(p, p[i % 3] * 0.1), 0, 1});
  }
  EXPECT_LE(checked_depth(items), deepest);
}

TEST(Bvh, NestedBounds) {
  std::vector<BvhItem> items;
  const int count = scaled(50000, 5000);
  for (int i = 0; i < count; i++) items.push_back({box_at({0, 0, 0}, std::exp2(i * 200.0 / count - 100)), 0, 1});
  EXPECT_LE(checked_depth(items), deepest);
}

TEST(Bvh, FlatItemsInOnePlane) {
  Random random(2);
  std::vector<BvhItem> items;
  for (int i = 0; i < 5000; i++) {
    const Vec3 p{uniform(random, -1, 1), 5, uniform(random, -1, 1)};
    items.push_back({{p, p + Vec3{0.1, 0, 0.1}}, 0, 1});
  }
  EXPECT_LE(checked_depth(items), deepest);
}

}  // namespace
}  // namespace penumbra::test
