// What a packet must never show: that rays travel together, how many of them, and which of the two questions is asked.
// Without Embree all answers have the same bits, whatever the company and the instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "base/test_scale.hpp"
#include "geometry/probing.hpp"
#include "geometry/random_scene.hpp"

namespace penumbra::test {
namespace {

struct PacketTest : testing::TestWithParam<int> {
  void make(bool with_triangle_runs) {
    const auto seed = static_cast<std::uint64_t>(GetParam());
    maker = random_scene(seed, with_triangle_runs);
    WorldOptions options;
    options.embree_threshold = with_triangle_runs ? 200 : 0xffffffffu;
    world = build_world(maker.scene(), options);
    Random random(seed + 77);
    const int count = scaled(30000, 1000);
    for (int i = 0; i < count; i++) {
      const Vec3 origin = random_point(random, 10);
      const Vec3 target = random_point(random, 6);
      ProbeRay ray = probe_ray(origin, normalize(target - origin) * uniform(random, 0.2, 3), uniform(random, 0, 1));
      if (i % 2 == 1) ray.farthest = static_cast<float>(uniform(random, 0, 10));
      rays.push_back(ray);
    }
  }

  SceneMaker maker;
  World world;
  std::vector<ProbeRay> rays;
};

bool same_bits(const ProbeHit& a, const ProbeHit& b) {
  if (!std::isfinite(a.distance) || !std::isfinite(b.distance)) return a.distance == b.distance;
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST_P(PacketTest, AnswersDoNotDependOnPacketMates) {
  make(false);
  std::vector<std::size_t> order(rays.size());
  std::iota(order.begin(), order.end(), 0);
  Random random(5);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<ProbeRay> shuffled;
  for (const std::size_t i : order) shuffled.push_back(rays[i]);
  for (const Kernel* kernel : usable_kernels()) {
    SCOPED_TRACE(kernel->isa);
    const std::vector<ProbeHit> hits = hits_of(*kernel, world, rays);
    const std::vector<ProbeHit> shuffled_hits = hits_of(*kernel, world, shuffled);
    const std::vector<char> blocked = blocked_of(*kernel, world, rays);
    const std::vector<char> shuffled_blocked = blocked_of(*kernel, world, shuffled);
    int different = 0;
    for (std::size_t i = 0; i < order.size(); i++) {
      different += !same_bits(hits[order[i]], shuffled_hits[i]);
      different += blocked[order[i]] != shuffled_blocked[i];
    }
    EXPECT_EQ(different, 0);
  }
}

TEST_P(PacketTest, AllInstructionSetsGiveTheSameBits) {
  make(false);
  const std::vector<ProbeHit> hits = hits_of(*usable_kernels().front(), world, rays);
  const std::vector<char> blocked = blocked_of(*usable_kernels().front(), world, rays);
  EXPECT_GT(std::count_if(hits.begin(), hits.end(), [](const ProbeHit& h) { return std::isfinite(h.distance); }),
            static_cast<std::ptrdiff_t>(hits.size() / 10));
  for (const Kernel* kernel : usable_kernels()) {
    SCOPED_TRACE(kernel->isa);
    const std::vector<ProbeHit> others = hits_of(*kernel, world, rays);
    int different = 0;
    for (std::size_t i = 0; i < rays.size(); i++) different += !same_bits(hits[i], others[i]);
    EXPECT_EQ(different, 0);
    EXPECT_EQ(blocked_of(*kernel, world, rays), blocked);
  }
}

TEST_P(PacketTest, BothQuestionsAgree) {
  make(false);
  for (const Kernel* kernel : usable_kernels()) {
    SCOPED_TRACE(kernel->isa);
    const std::vector<ProbeHit> hits = hits_of(*kernel, world, rays);
    const std::vector<char> blocked = blocked_of(*kernel, world, rays);
    int different = 0;
    for (std::size_t i = 0; i < rays.size(); i++) different += std::isfinite(hits[i].distance) != (blocked[i] != 0);
    EXPECT_EQ(different, 0);
  }
}

// Embree has its own arithmetic for the second question: rays that end on a triangle to the last digit may differ.
TEST_P(PacketTest, BothQuestionsAgreeWithMeshes) {
  make(true);
  for (const Kernel* kernel : usable_kernels()) {
    SCOPED_TRACE(kernel->isa);
    const std::vector<ProbeHit> hits = hits_of(*kernel, world, rays);
    const std::vector<char> blocked = blocked_of(*kernel, world, rays);
    int different = 0;
    for (std::size_t i = 0; i < rays.size(); i++) different += std::isfinite(hits[i].distance) != (blocked[i] != 0);
    EXPECT_LE(different, 1);
  }
}

TEST_P(PacketTest, FarthestIsExclusive) {
  make(false);
  const Kernel& kernel = *usable_kernels().back();
  std::vector<ProbeRay> ending = rays;
  const std::vector<ProbeHit> hits = hits_of(kernel, world, rays);
  for (std::size_t i = 0; i < rays.size(); i++) {
    if (std::isfinite(hits[i].distance)) ending[i].farthest = hits[i].distance;
  }
  for (const char blocked : blocked_of(kernel, world, ending)) EXPECT_EQ(blocked, 0);
  for (const ProbeHit& hit : hits_of(kernel, world, ending)) EXPECT_FALSE(std::isfinite(hit.distance));
}

INSTANTIATE_TEST_SUITE_P(RandomScenes, PacketTest, testing::Values(31, 32, 33));

}  // namespace
}  // namespace penumbra::test
