// Building a world of many shapes: every leaf has one place, inside of the bounds above it, and the number of threads
// does not show in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/test_scale.hpp"
#include "geometry/random_scene.hpp"
#include "geometry/world.hpp"

namespace penumbra::test {
namespace {

constexpr int many = scaled(40000, 20000);  // more than one thread takes

Shape random_shape(Random& random) {
  const Vec3 p = random_point(random, 10);
  const double size = uniform(random, 0.01, 0.1);
  switch (random() % 4) {
    case 0:
      return Sphere{p, size};
    case 1:
      return Box{p, p + Vec3{size, size, size}};
    case 2:
      return Cylinder{size, p.x, p.z, p.y, p.y + size, true};
    default:
      return Cone{p, size, 0.5};
  }
}

Object random_object(SceneMaker& maker, Random& random) {
  const Affine m = random() % 3 == 0 ? random_placement(random, 1) : Affine{};
  return maker.object(random_shape(random), m, random() % 5 == 0 ? random_direction(random) : Vec3{});
}

Objects random_objects(SceneMaker& maker, Random& random, int count) {
  Objects objects;
  for (int i = 0; i < count; i++) objects.push_back(random_object(maker, random));
  return objects;
}

// Long and short lists of shapes, triangles among them, groups in groups, and instances of a large group.
SceneMaker mixed_scene() {
  Random random(1);
  SceneMaker maker;
  for (Object& object : random_objects(maker, random, many)) maker.add(std::move(object));
  maker.add(maker.object(maker.triangles(icosphere(3))));
  const std::uint32_t definition =
      maker.define(maker.object(SceneMaker::group(random_objects(maker, random, many)), {}, {}));
  for (int i = 0; i < 20; i++) {
    maker.add(random_object(maker, random));
    maker.add(maker.object(Instance{definition}, random_placement(random, 5)));
    maker.add(maker.object(maker.triangles(icosphere(1)), {}, {1, 0, 0}));
  }
  Objects outer = random_objects(maker, random, 100);
  outer.push_back(maker.object(SceneMaker::group(random_objects(maker, random, 9000)), {}, {0, 1, 0}));
  outer.push_back(maker.object(SceneMaker::group({})));
  maker.add(maker.object(SceneMaker::group(std::move(outer)), {}, {0, 0, 1}));
  return maker;
}

template <class Vector>
void expect_same_bytes(const Vector& a, const Vector& b) {
  ASSERT_EQ(a.size(), b.size());
  if (a.size() == 0) return;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])), 0);
}

// Of its own union's shape; what lies between and behind its numbers may be anything.
std::vector<float> numbers_of(const Leaf& leaf) {
  const auto floats = [](const auto& shape) {
    std::vector<float> numbers(sizeof(shape) / sizeof(float));
    std::memcpy(numbers.data(), &shape, sizeof(shape));
    return numbers;
  };
  switch (leaf.kind) {
    case LeafKind::sphere: {
      const LeafSphere& s = leaf.sphere;
      return {s.center[0], s.center[1], s.center[2], s.radius, s.power, static_cast<float>(s.is_ground)};
    }
    case LeafKind::cylinder: {
      const LeafCylinder& c = leaf.cylinder;
      return {c.x, c.z, c.radius, c.y_min, c.y_max, static_cast<float>(c.capped)};
    }
    case LeafKind::box:
      return floats(leaf.box);
    case LeafKind::cone:
      return floats(leaf.cone);
    case LeafKind::triangle:
      return floats(leaf.triangle);
    default:
      return {};
  }
}

bool same_leaf(const Leaf& a, const Leaf& b) {
  return a.kind == b.kind && a.passage == b.passage && a.moves == b.moves && a.order == b.order &&
         a.target == b.target && a.placement == b.placement && a.place == b.place &&
         std::ranges::equal(a.motion, b.motion) && a.slack == b.slack && numbers_of(a) == numbers_of(b);
}

void expect_same(const World& a, const World& b) {
  expect_same_bytes(a.nodes, b.nodes);
  EXPECT_TRUE(std::ranges::equal(a.leaves, b.leaves, same_leaf));
  expect_same_bytes(a.placements, b.placements);
  expect_same_bytes(a.groups, b.groups);
  expect_same_bytes(a.leaf_normals, b.leaf_normals);
  EXPECT_EQ(a.reach, b.reach);
  EXPECT_EQ(a.counts, b.counts);
}

World build(const Scene& scene, int threads, Vec3 origin = {}) {
  WorldOptions options;
  options.threads = threads;
  options.origin = origin;
  return build_world(scene, options);
}

TEST(BuildWorld, IsTheSameWithAnyNumberOfThreads) {
  const SceneMaker maker = mixed_scene();
  for (const Vec3 origin : {Vec3{}, Vec3{1, 2, 3}}) {
    const World world = build(maker.scene(), 1, origin);
    for (const int threads : {2, 3, 7}) expect_same(world, build(maker.scene(), threads, origin));
  }
}

// Counts how often each leaf below a node is there, and the spheres that are not inside of all bounds above them.
struct Walk {
  const World& world;
  std::vector<int> seen = std::vector<int>(world.leaves.size());
  int outside = 0;

  void visit(NodeReference reference, const float (&bounds)[6]) {
    if (!is_leaf(reference)) {
      const Node& node = world.nodes.at(reference);
      for (int child = 0; child < 2; child++) {
        for (int axis = 0; axis < 3; axis++) {
          outside += node.bounds[child][axis] < bounds[axis] || node.bounds[child][3 + axis] > bounds[3 + axis];
        }
        visit(node.child[child], node.bounds[child]);
      }
      return;
    }
    for (std::uint32_t i = leaf_first(reference); i < leaf_first(reference) + leaf_count(reference); i++) {
      seen.at(i)++;
      const Leaf& leaf = world.leaves[i];
      if (leaf.kind != LeafKind::sphere || leaf.placement != no_placement) continue;
      for (int axis = 0; axis < 3; axis++) {
        outside += leaf.sphere.center[axis] - leaf.sphere.radius < bounds[axis];
        outside += leaf.sphere.center[axis] + leaf.sphere.radius > bounds[3 + axis];
      }
    }
  }
};

TEST(BuildWorld, HoldsEveryLeafOnceInsideOfItsBounds) {
  const SceneMaker maker = mixed_scene();
  const World world = build(maker.scene(), 2);
  Walk walk{world};
  const float everywhere[6] = {-1e30f, -1e30f, -1e30f, 1e30f, 1e30f, 1e30f};
  for (const WorldGroup& group : world.groups) walk.visit(group.root, everywhere);
  EXPECT_EQ(std::count(walk.seen.begin(), walk.seen.end(), 1), static_cast<std::ptrdiff_t>(world.leaves.size()));
  EXPECT_EQ(walk.outside, 0);
}

TEST(BuildWorld, NoObjects) {
  SceneMaker maker;
  const World world = build(maker.scene(), 2);
  EXPECT_EQ(leaf_count(world.groups[0].root), 0u);
}

TEST(BuildWorld, EmptyGroups) {
  SceneMaker maker;
  const std::uint32_t definition = maker.define(maker.object(SceneMaker::group({})));
  maker.add(maker.object(Instance{definition}));
  maker.add(maker.object(SceneMaker::group({})));
  const World world = build(maker.scene(), 2);
  EXPECT_TRUE(world.leaves.empty());
}

TEST(BuildWorld, OneObject) {
  SceneMaker maker;
  maker.add(maker.object(Sphere{{1, 2, 3}, 1}));
  const World world = build(maker.scene(), 2);
  EXPECT_EQ(world.groups[0].root, leaf_reference(0, 1));
  EXPECT_TRUE(world.nodes.empty());
}

}  // namespace
}  // namespace penumbra::test
