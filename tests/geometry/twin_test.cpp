// The packet world against the brute-force twin, on a million random rays in random scenes of all shapes. A packet's
// answer is right when it is the twin's answer for the same ray to single precision. Near an edge or a tie it may also
// be the twin's answer for a ray that is shifted by 1e-4 of the scene's size; so may at most one ray in a thousand.
#include <gtest/gtest.h>

#include <cmath>

#include "base/test_scale.hpp"
#include "geometry/brute_force.hpp"
#include "geometry/probing.hpp"
#include "geometry/random_scene.hpp"

namespace penumbra::test {
namespace {

constexpr double scene_size = 10;
constexpr int scene_count = scaled(20, 4);
constexpr int rays_in_scene = scaled(50000, 1000);

Vec3 vec(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

BruteRay brute_ray(const ProbeRay& ray) { return {vec(ray.origin), vec(ray.direction), ray.time}; }

std::vector<ProbeRay> random_rays(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<ProbeRay> rays;
  for (int i = 0; i < count; i++) {
    const Vec3 origin = random_point(random, scene_size);
    const Vec3 target = random_point(random, 0.6 * scene_size);
    const double size = std::exp(uniform(random, -2, 2));
    ProbeRay ray = probe_ray(origin, normalize(target - origin) * size, uniform(random, 0, 1));
    if (i % 2 == 1) ray.farthest = static_cast<float>(uniform(random, 0, scene_size) / size);
    // Now and then along an axis, where slabs divide by zero.
    if (i % 50 == 0) ray.direction[i / 50 % 3] = 0;
    if (i % 100 == 0) ray.direction[(i / 50 + 1) % 3] = 0;
    rays.push_back(ray);
  }
  return rays;
}

bool same_hit(const ProbeRay& ray, const ProbeHit& packet, const BruteHit& twin, double tolerance) {
  const bool found = std::isfinite(packet.distance);
  const bool twin_found = twin.distance < ray.farthest;
  if (!found || !twin_found) return found == twin_found;
  const double speed = length(vec(ray.direction));
  return packet.surface == twin.surface && std::abs(packet.distance - twin.distance) * speed <= tolerance &&
         length(vec(packet.point) - twin.point) <= tolerance &&
         length(vec(packet.normal) - twin.normal) <= 100 * tolerance;
}

// Whether `accept` holds for any of the rays that run 1e-4 of the scene's size beside this one, or start or end so much
// sooner or later.
template <typename Accept>
bool holds_nearby(const ProbeRay& ray, const BruteForce& twin, Accept accept) {
  const BruteRay middle = brute_ray(ray);
  const Vec3 d = normalize(middle.direction);
  const Vec3 u = normalize(std::abs(d.x) < 0.5 ? cross(d, {1, 0, 0}) : cross(d, {0, 1, 0}));
  const Vec3 v = cross(d, u);
  for (const double step : {1e-4, 1e-5}) {
    for (int i = 0; i < 16; i++) {
      const double angle = i * 0.3926990817;
      BruteRay beside = middle;
      beside.origin = beside.origin + (u * std::cos(angle) + v * std::sin(angle)) * (step * scene_size);
      if (accept(twin.intersect(beside), ray.farthest)) return true;
    }
    for (const double sign : {-1.0, 1.0}) {
      BruteRay shifted = middle;
      shifted.origin = shifted.origin + d * (sign * step * scene_size);
      if (accept(twin.intersect(shifted), ray.farthest)) return true;
    }
  }
  return false;
}

struct Tally {
  int rays = 0, doubtful = 0, wrong = 0;
};

void check(const ProbeRay& ray, const ProbeHit& packet, bool blocked, const BruteHit& exact, const BruteForce& twin,
           Tally& tally) {
  tally.rays++;
  const bool hit_agrees = same_hit(ray, packet, exact, 1e-6 * scene_size);
  const bool blocked_agrees = blocked == (exact.distance < ray.farthest);
  if (hit_agrees && blocked_agrees) return;
  const bool excused = (hit_agrees || holds_nearby(ray, twin,
                                                   [&](const BruteHit& hit, double) {
                                                     return same_hit(ray, packet, hit, 3e-4 * scene_size);
                                                   })) &&
                       (blocked_agrees || holds_nearby(ray, twin, [&](const BruteHit& hit, double farthest) {
                          return blocked == (hit.distance < farthest);
                        }));
  tally.doubtful++;
  if (excused) return;
  if (tally.wrong++ < 5) {
    ADD_FAILURE() << "packet: distance " << packet.distance << " surface " << packet.surface << " normal "
                  << packet.normal[0] << " " << packet.normal[1] << " " << packet.normal[2] << " blocked " << blocked
                  << "\ntwin: distance " << exact.distance << " surface " << exact.surface << " normal "
                  << exact.normal.x << " " << exact.normal.y << " " << exact.normal.z << "\nfarthest " << ray.farthest;
  }
}

class Twin : public testing::TestWithParam<int> {};

TEST_P(Twin, AgreesWithThePackets) {
  const int seed = GetParam();
  const SceneMaker maker = random_scene(static_cast<std::uint64_t>(seed), true);
  WorldOptions options;
  options.embree_threshold = 200;
  const World world = build_world(maker.scene(), options);
  ASSERT_FALSE(world.meshes.empty());
  const BruteForce twin(maker.scene());
  const std::vector<ProbeRay> rays = random_rays(static_cast<std::uint64_t>(1000 + seed), rays_in_scene);
  std::vector<BruteHit> exact;
  for (const ProbeRay& ray : rays) exact.push_back(twin.intersect(brute_ray(ray)));
  for (const Kernel* kernel : usable_kernels()) {
    SCOPED_TRACE(kernel->isa);
    const std::vector<ProbeHit> hits = hits_of(*kernel, world, rays);
    const std::vector<char> blocked = blocked_of(*kernel, world, rays);
    Tally tally;
    for (std::size_t i = 0; i < rays.size(); i++) check(rays[i], hits[i], blocked[i] != 0, exact[i], twin, tally);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_LE(tally.doubtful, std::max(tally.rays / 1000, 2));
    RecordProperty(kernel->isa, tally.doubtful);
  }
}

INSTANTIATE_TEST_SUITE_P(RandomScenes, Twin, testing::Range(1, scene_count + 1));

}  // namespace
}  // namespace penumbra::test
