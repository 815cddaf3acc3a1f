// The tree over the bounds of a group's leaves: nothing is lost, every node's bounds hold what is below it, no input
// makes it deeper than the traversal has stack for, and the number of threads does not show.
#include "geometry/bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/test_scale.hpp"
#include "geometry/random_scene.hpp"

namespace penumbra::test {
namespace {

constexpr std::uint32_t first_leaf = 17;  // of the group, in the world
constexpr int deepest = 60;

using Items = ZeroedVector<BvhItem>;

Bounds bounds_of(const BvhItem& item) {
  return {{item.lo[0], item.lo[1], item.lo[2]}, {item.hi[0], item.hi[1], item.hi[2]}};
}

void add(Items& items, const Bounds& bounds, std::uint32_t cost = 1) {
  BvhItem& item = items.emplace_back();
  set3(item.lo, bounds.lo);
  set3(item.hi, bounds.hi);
  item.leaf = static_cast<std::uint32_t>(items.size() - 1);
  item.cost = cost;
}

struct Walk {
  const Items& items;
  const Bvh& bvh;
  const ZeroedVector<Node>& nodes;
  std::vector<int> seen;
  int depth = 0;

  Bounds visit(NodeReference node, int level) {
    depth = std::max(depth, level);
    Bounds bounds;
    if (is_leaf(node)) {
      EXPECT_LE(leaf_count(node), max_leaves_in_node);
      for (std::uint32_t i = leaf_first(node); i < leaf_first(node) + leaf_count(node); i++) {
        const std::uint32_t leaf = bvh.order.at(i - first_leaf);
        seen.at(leaf)++;
        bounds = include(bounds, bounds_of(items.at(leaf)));
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

// Builds the tree on one thread and on several, checks it, and returns its depth.
int checked_depth(const Items& items) {
  ZeroedVector<Node> nodes(3);  // of another group
  const Bvh bvh = build_bvh(items, first_leaf, 1, nodes);
  Walk walk{items, bvh, nodes, std::vector<int>(items.size()), 0};
  const Bounds bounds = walk.visit(bvh.root, 0);
  EXPECT_EQ(bounds.lo, bvh.bounds.lo);
  EXPECT_EQ(bounds.hi, bvh.bounds.hi);
  EXPECT_EQ(bvh.order.size(), items.size());
  EXPECT_EQ(std::count(walk.seen.begin(), walk.seen.end(), 1), static_cast<std::ptrdiff_t>(items.size()));
  for (const int threads : {2, 3, 7}) {
    ZeroedVector<Node> other_nodes(3);
    const Bvh other = build_bvh(items, first_leaf, threads, other_nodes);
    EXPECT_EQ(other.root, bvh.root);
    EXPECT_EQ(other.order, bvh.order);
    EXPECT_EQ(other_nodes.size(), nodes.size());
    if (other_nodes.size() != nodes.size()) break;
    EXPECT_EQ(std::memcmp(other_nodes.data(), nodes.data(), nodes.size() * sizeof(Node)), 0) << threads << " threads";
  }
  return walk.depth;
}

Bounds box_at(Vec3 p, double size) { return grow({p, p}, size); }

Items at_one_place(int count, const Bounds& bounds) {
  Items items;
  for (int i = 0; i < count; i++) add(items, bounds);
  return items;
}

// From 2^14 items on, threads are used.
TEST(Bvh, HoldsEveryItemOfRandomInput) {
  Random random(1);
  for (const int count : {0, 1, 2, 3, 8, 9, 16, 17, 31, 32, 500, 513, 16384, 16385, scaled(100000, 20000)}) {
    Items items;
    for (int i = 0; i < count; i++) {
      add(items, box_at(random_point(random, 10), std::exp(uniform(random, -6, 1))),
          static_cast<std::uint32_t>(uniform(random, 1, 17)));
    }
    EXPECT_LE(checked_depth(items), 40) << count;
  }
}

TEST(Bvh, ClustersFarApart) {
  Random random(3);
  Items items;
  for (int cluster = 0; cluster < 40; cluster++) {
    const Vec3 center = random_point(random, 1000);
    const double size = std::exp(uniform(random, -8, 0));
    for (int i = 0; i < scaled(2000, 500); i++) add(items, box_at(center + random_point(random, size), 0.01 * size));
  }
  EXPECT_LE(checked_depth(items), 50);
}

TEST(Bvh, ItemsAtTheSamePlace) {
  const int count = scaled(100000, 20000);
  EXPECT_LE(checked_depth(at_one_place(count, box_at({1, 2, 3}, 1))), 20);
  EXPECT_LE(checked_depth(at_one_place(count, box_at({1, 2, 3}, 0))), 20);
  EXPECT_LE(checked_depth(at_one_place(15, box_at({1, 2, 3}, 0))), 20);
  Items items = at_one_place(count, box_at({1, 2, 3}, 1));
  add(items, box_at({100, 2, 3}, 1));
  EXPECT_LE(checked_depth(items), 30);
}

TEST(Bvh, ExponentiallyGrowingPositions) {
  Items items;
  const int count = scaled(100000, 20000);
  for (int i = 0; i < count; i++) {
    const double x = std::exp2(-100 + 200.0 * i / count);
    add(items, box_at({x, 0, 0}, x * 1e-7));
  }
  EXPECT_LE(checked_depth(items), deepest);
  // One far from the next by a factor of two, in all three axes by turns.
  items.clear();
  for (int i = 0; i < 250; i++) {
    Vec3 p;
    p[i % 3] = std::exp2(i - 125);
    for (int k = 0; k < scaled(100, 20); k++) add(items, box_at(p, p[i % 3] * 0.1));
  }
  EXPECT_LE(checked_depth(items), deepest);
}

TEST(Bvh, NestedBounds) {
  Items items;
  const int count = scaled(50000, 20000);
  for (int i = 0; i < count; i++) add(items, box_at({0, 0, 0}, std::exp2(i * 200.0 / count - 100)));
  EXPECT_LE(checked_depth(items), deepest);
}

TEST(Bvh, FlatItemsInOnePlane) {
  Random random(2);
  Items items;
  for (int i = 0; i < 20000; i++) {
    const Vec3 p{uniform(random, -1, 1), 5, uniform(random, -1, 1)};
    add(items, {p, p + Vec3{0.1, 0, 0.1}});
  }
  EXPECT_LE(checked_depth(items), deepest);
}

TEST(Bvh, LargestAndSmallestNumbers) {
  Random random(4);
  for (const double size : {3e38, 1e-38, 1e-44}) {
    Items items;
    for (int i = 0; i < 20000; i++) add(items, box_at(random_point(random, size), 0.01 * size));
    EXPECT_LE(checked_depth(items), deepest) << size;
  }
}

}  // namespace
}  // namespace penumbra::test
