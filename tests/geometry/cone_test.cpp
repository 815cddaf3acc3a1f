// The cone: hits worked out by hand, no way out along the rim, and points on the exact surface whatever its size, its
// opening and its distance.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/test_scale.hpp"
#include "geometry/brute_force.hpp"
#include "geometry/probing.hpp"
#include "geometry/random_scene.hpp"

namespace penumbra::test {
namespace {

constexpr double epsilon = 0x1p-24;  // the rounding error of single precision

Vec3 vec(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

World world_of(const Cone& cone, const Affine& m = {}, Vec3 motion = {}) {
  SceneMaker maker;
  maker.add(maker.object(cone, m, motion));
  return build_world(maker.scene(), {});
}

// The answer of all kernels for one ray, to both questions.
ProbeHit hit_of(const World& world, Vec3 origin, Vec3 direction, double time = 0) {
  ProbeHit hit{};
  for (const Kernel* kernel : usable_kernels()) {
    const std::vector<ProbeRay> ray{probe_ray(origin, direction, time)};
    hit = hits_of(*kernel, world, ray)[0];
    EXPECT_EQ(blocked_of(*kernel, world, ray)[0] != 0, std::isfinite(hit.distance)) << kernel->isa;
  }
  return hit;
}

void expect_hit(const ProbeHit& hit, double distance, Vec3 point, Vec3 normal) {
  EXPECT_NEAR(hit.distance, distance, 8 * epsilon * distance);
  EXPECT_LE(length(vec(hit.point) - point), 8 * epsilon * max_component(abs(point)));
  EXPECT_LE(length(vec(hit.normal) - normal), 8 * epsilon);
}

bool is_missed(const ProbeHit& hit) { return !std::isfinite(hit.distance); }

// How far a point is from the side or the cap of a cone, whichever is nearer.
double distance_to_surface(const Cone& cone, Vec3 p) {
  const Vec3 q = p - cone.apex;
  const double side = std::abs(std::hypot(q.x, q.z) - cone.slope * q.y) / std::hypot(1, cone.slope);
  return std::min(side, std::abs(q.y - cone.height));
}

// A point of the side, `height` above the apex.
Vec3 on_side(const Cone& cone, double height, double angle) {
  const double r = cone.slope * height;
  return cone.apex + Vec3{r * std::cos(angle), height, r * std::sin(angle)};
}

const Cone upright{{1, 2, 3}, 4, 0.75};  // up to y = 6, where its radius is 3; its side has the slope 3 : 4

TEST(Cone, IsHitOnItsCap) {
  const World world = world_of(upright);
  expect_hit(hit_of(world, {1, 9, 3}, {0, -1, 0}), 3, {1, 6, 3}, {0, 1, 0});
  expect_hit(hit_of(world, {3.9, 9, 3}, {0, -1, 0}), 3, {3.9, 6, 3}, {0, 1, 0});
  expect_hit(hit_of(world, {0, 9, 0}, {0.5, -1, 1}), 3, {1.5, 6, 3}, {0, 1, 0});  // any length
  EXPECT_TRUE(is_missed(hit_of(world, {4.1, 9, 3}, {0, -1, 0})));
}

TEST(Cone, IsHitOnItsSide) {
  const World world = world_of(upright);
  // The radius is 1.5 at y = 4, and the normal falls by 3 : 4.
  expect_hit(hit_of(world, {-9, 4, 3}, {1, 0, 0}), 8.5, {-0.5, 4, 3}, {-0.8, -0.6, 0});
  expect_hit(hit_of(world, {1, 4, 9}, {0, 0, -1}), 4.5, {1, 4, 4.5}, {0, -0.6, 0.8});
  expect_hit(hit_of(world, {-0.5, -5, 3}, {0, 1, 0}), 9, {-0.5, 4, 3}, {-0.8, -0.6, 0});
  EXPECT_TRUE(is_missed(hit_of(world, {-9, 6.01, 3}, {1, 0, 0})));
  EXPECT_TRUE(is_missed(hit_of(world, {-9, 1.99, 3}, {1, 0, 0})));
  EXPECT_TRUE(is_missed(hit_of(world, {-9, 0, 3}, {1, 0, 0}))) << "there is no second half below the apex";
}

TEST(Cone, IsGrazed) {
  const World world = world_of(upright);
  const double half_chord = 1.5 * std::sqrt(2e-5 - 1e-10);
  const Vec3 point{1 - half_chord, 4, 3 + 1.5 * (1 - 1e-5)};
  const ProbeHit hit = hit_of(world, {-9, 4, point.z}, {1, 0, 0});
  EXPECT_NEAR(hit.distance, 10 - half_chord, 1e-4);  // the digits that the chord has when the radius has all of its own
  EXPECT_LE(length(vec(hit.normal) - Vec3{0, -0.6, 0.8}), 0.01);
  EXPECT_TRUE(is_missed(hit_of(world, {-9, 4, 3 + 1.5 * (1 + 1e-5)}, {1, 0, 0})));
}

TEST(Cone, IsHitAtItsApexAlongTheAxis) {
  const ProbeHit hit = hit_of(world_of(upright), {1, -5, 3}, {0, 1, 0});
  EXPECT_EQ(hit.distance, 7);
  EXPECT_EQ(vec(hit.point), (Vec3{1, 2, 3}));
  EXPECT_NEAR(length(vec(hit.normal)), 1, 4 * epsilon);
}

TEST(Cone, IsLeftFromInside) {
  const World world = world_of(upright);
  expect_hit(hit_of(world, {1, 4, 3}, {1, 0, 0}), 1.5, {2.5, 4, 3}, {0.8, -0.6, 0});
  expect_hit(hit_of(world, {1, 4, 3}, {0, 1, 0}), 2, {1, 6, 3}, {0, 1, 0});
  expect_hit(hit_of(world, {2, 5, 3}, {0, -1, 0}), 5 - 2 - 4.0 / 3, {2, 2 + 4.0 / 3, 3}, {0.8, -0.6, 0});
}

// A ray as steep as the side crosses it once at most; the quadratic has no square.
TEST(Cone, IsHitByRaysThatRunAlongItsSide) {
  const Cone cone{{0, 0, 0}, 2, 1};
  const World world = world_of(cone);
  const double r = std::numbers::sqrt2, s = std::sqrt(0.5);
  expect_hit(hit_of(world, {-3, 0, 0}, {1, 1, 0}), 1.5, {-1.5, 1.5, 0}, {-s, -s, 0});
  expect_hit(hit_of(world, {-0.5, 1, 0}, {s, s, 0}), r, {0.5, 2, 0}, {0, 1, 0});
  expect_hit(hit_of(world, {0.5, 3, 0}, {-s, -s, 0}), r, {-0.5, 2, 0}, {0, 1, 0});
  // In a plane that touches the cone, beside the line in which it does.
  EXPECT_TRUE(is_missed(hit_of(world, {0.5, -3, -3}, {0, 1, 1})));
  EXPECT_TRUE(is_missed(hit_of(world, {0.5, 3, 3}, {0, -1, -1})));
}

TEST(Cone, FollowsItsMotionAndItsInstance) {
  expect_hit(hit_of(world_of(upright, {}, {0, 2, 0}), {-9, 4, 3}, {1, 0, 0}, 0.5), 9.25, {0.25, 4, 3}, {-0.8, -0.6, 0});
  SceneMaker maker;
  const std::uint32_t name = maker.define(maker.object(upright));
  maker.add({Instance{name}, 0, maker.placement(translation({0, 0, 10}) * rotation(180, {1, 0, 0})), {}});
  expect_hit(hit_of(build_world(maker.scene(), {}), {-9, -4, 7}, {1, 0, 0}), 8.5, {-0.5, -4, 7}, {-0.8, 0.6, 0});
}

TEST(Cone, RemainsOneUnderMapsThatKeepItUpright) {
  const Affine turned = translation({1, -2, 0.5}) * rotation(50, {0, 1, 0});
  const auto is_kept = [&](const Affine& m) { return world_of(upright, m).leaves.at(0).placement == no_placement; };
  EXPECT_TRUE(is_kept(turned * scaling({2, 2, 2})));
  EXPECT_TRUE(is_kept(turned * scaling({2, 0.5, 2})));
  EXPECT_TRUE(is_kept(turned * scaling({-2, 0.5, 2})));
  EXPECT_FALSE(is_kept(turned * scaling({2, -1, 2})));
  EXPECT_FALSE(is_kept(turned * scaling({2, 1, 1})));
  EXPECT_FALSE(is_kept(rotation(1, {1, 0, 0})));
  // Twice as wide, half as high: the radius at y = 2 is 3.
  expect_hit(hit_of(world_of(upright, scaling({2, 0.5, 2})), {-9, 2, 6}, {1, 0, 0}), 8, {-1, 2, 6},
             normalize({-0.5, -1.5, 0}));
}

// From inside there is no way out past the rim, the apex or anything between, under any matrix; and no ray from outside
// that is aimed just inside the rim slips through it.
TEST(Cone, HasNoGapAlongItsRim) {
  Random random(3);
  for (int i = 0; i < scaled(100, 20); i++) {
    const Affine m = i % 4 == 0 ? translation(random_point(random, 50)) : random_placement(random, 5);
    const Cone cone{random_point(random, 1), uniform(random, 0.1, 3), std::exp(uniform(random, -4, 4))};
    const World world = world_of(cone, m);
    std::vector<ProbeRay> rays;
    const auto add = [&](Vec3 origin, Vec3 target) {
      const Vec3 from = transform_point(m, origin);
      rays.push_back(probe_ray(from, normalize(transform_point(m, target) - from), 0));
    };
    for (int k = 0; k < 1000; k++) {
      const double angle = uniform(random, 0, 2 * std::numbers::pi);
      const Vec3 rim = on_side(cone, cone.height, angle);
      const Vec3 target = k % 10 == 0 ? cone.apex : k % 3 == 0 ? on_side(cone, cone.height / 2, angle) : rim;
      const Vec3 axis = cone.apex + Vec3{0, 0.6 * cone.height, 0};
      const Vec3 away =
          on_side(cone, uniform(random, 0.2, 0.9) * cone.height, uniform(random, 0, 2 * std::numbers::pi));
      add(axis + (away - axis) * uniform(random, 0, 0.9), target);
      // Where the solid is thick enough for a ray from far away; flat cones have a sharp rim.
      const double size = cone.height * std::max(1.0, cone.slope);
      const Vec3 inside = rim + normalize(axis - rim) * (3e-5 * (5 + size) * std::max(1.0, cone.slope));
      add(rim + random_direction(random) * uniform(random, 1, 20) * size, inside);
    }
    for (const Kernel* kernel : usable_kernels()) {
      int lost = 0;
      for (const ProbeHit& hit : hits_of(*kernel, world, rays)) lost += is_missed(hit);
      for (const char blocked : blocked_of(*kernel, world, rays)) lost += blocked == 0;
      EXPECT_EQ(lost, 0) << kernel->isa << ", slope " << cone.slope;
    }
  }
}

// Against double precision: cones of all sizes and openings, near and far, hit from everywhere. The ray has the error
// of its origin; the point lies on the surface as well as single precision can say.
TEST(Cone, IsHitExactlyWhateverItsSize) {
  Random random(7);
  for (int i = 0; i < scaled(400, 60); i++) {
    const double size = std::exp(uniform(random, std::log(1e-4), std::log(1e5)));
    const double slope = std::exp(uniform(random, std::log(0.02), std::log(50)));
    const double height = size / std::max(1.0, slope);
    SceneMaker maker;
    const Vec3 offset = i % 2 == 0 ? Vec3{} : random_point(random, 100 * size);
    const ProbeRay rounded = probe_ray(offset, {}, 0);
    const Cone cone{vec(rounded.origin), height, slope};
    maker.add(maker.object(cone));
    const World world = build_world(maker.scene(), {});
    const BruteForce twin(maker.scene());
    std::vector<ProbeRay> rays;
    for (int k = 0; k < 300; k++) {
      const Vec3 target = on_side(cone, height * uniform(random, 0, 1), uniform(random, 0, 2 * std::numbers::pi));
      const Vec3 origin = target + random_direction(random) * size * std::exp(uniform(random, -1, 3));
      rays.push_back(probe_ray(origin, normalize(target - origin) * std::exp(uniform(random, -3, 3)), 0));
    }
    for (const Kernel* kernel : usable_kernels()) {
      const std::vector<ProbeHit> hits = hits_of(*kernel, world, rays);
      int differ = 0;
      for (std::size_t k = 0; k < rays.size(); k++) {
        const Vec3 origin = vec(rays[k].origin), direction = vec(rays[k].direction);
        const double scale = std::max(max_component(abs(origin)), max_component(abs(cone.apex)) + size);
        const BruteHit exact = twin.intersect({origin, direction, 0});
        if (std::isfinite(hits[k].distance)) {
          const Vec3 point = vec(hits[k].point);
          EXPECT_LE(distance_to_surface(cone, point), 4 * epsilon * scale) << slope << " " << size;
          EXPECT_NEAR(length(vec(hits[k].normal)), 1, 8 * epsilon);
          // Beside the ray by no more than it is inexact itself.
          const Vec3 beside = cross(point - origin, normalize(direction));
          EXPECT_LE(length(beside), 40 * epsilon * scale) << slope << " " << size;
        }
        differ += std::isfinite(hits[k].distance) != exact.found() ||
                  (exact.found() && std::abs(hits[k].distance - exact.distance) * length(direction) > 1e-3 * size);
      }
      EXPECT_LE(differ, 6) << slope << " " << size << " " << kernel->isa;
    }
  }
}

}  // namespace
}  // namespace penumbra::test
