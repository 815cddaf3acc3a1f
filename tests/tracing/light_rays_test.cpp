// Scenes with many lights: each hit sends a few shadow rays to lights that it chooses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>

#include "base/test_scale.hpp"
#include "rendering/film_values.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

class RandomNumbers {
 public:
  explicit RandomNumbers(int seed) : random_(static_cast<std::uint32_t>(seed)) {}
  double between(double low, double high) { return low + (high - low) * (random_() >> 8) / double{1 << 24}; }

 private:
  std::mt19937 random_;
};

// Lights of all kinds over a floor with balls, some of them shiny.
std::string random_lights(int number, int lights) {
  RandomNumbers r(number);
  std::string text = "image_size 6 6\nfov 50\nrays_per_pixel 4\neye 0 1 0\n";
  for (int i = 0; i < lights; i++) {
    const double x = r.between(-5, 5), y = r.between(0.2, 4), z = r.between(-9, 0), c = r.between(0, 2.0 / lights);
    const std::string color = fmt::format("{} {} {}", c, c * r.between(0, 1), c * r.between(0, 1));
    switch (i % 4) {
      case 0:
        text += fmt::format("light {} {} {} {}\n", x, y, z, color);
        break;
      case 1:
        text += fmt::format("disk_light {} {} {} 0.3 0 -1 0.2 {}\n", x, y, z, color);
        break;
      case 2:
        text += fmt::format("quad_light {} {} {} 0.3 0 0 0 0.1 0.2 {}\n", x, y, z, color);
        break;
      default:
        text +=
            fmt::format("spotlight {} {} {} {} -1 {} 20 50 {}\n", x, y, z, r.between(-1, 1), r.between(-1, 1), color);
    }
  }
  text += "diffuse 0.6 0.6 0.6 0.05 0.05 0.05\nbegin\nvertex -30 -1 20\nvertex 30 -1 20\nvertex 0 -1 -60\nend\n";
  for (int i = 0; i < 5; i++) {
    text +=
        fmt::format("surface {0} 0.3 0.3 0 0 0 {1} {1} {1} 20 {2}\nsphere 0.6 {3} {4} {5}\n", r.between(0, 0.8),
                    number % 2 ? 0.4 : 0, number % 3 ? 0.2 : 0, r.between(-2, 2), r.between(-1, 1), r.between(-7, -3));
  }
  return text;
}

Scene with_light_rays(Scene scene, int rays) {
  scene.settings.light_rays = rays;
  return scene;
}

TEST(LightRays, KeepTheMean) {
  constexpr int scenes = scaled(20, 5), seeds = 64;
  for (int number = 0; number < scenes; number++) {
    // Few clusters; several for each ray; more than rays, so that they are chosen.
    const int rays = std::array{4, 9, 1}[static_cast<std::size_t>(number) % 3], lights = number % 3 == 2 ? 200 : 37;
    Scene scene = scene_from(random_lights(number, lights));
    RenderSettings settings;
    settings.transparent_shadows = number % 5 == 4;
    settings.shadows = number % 7 != 6;
    double sum = 0, squares = 0, whole = 0;
    for (int seed = 0; seed < seeds; seed++) {
      scene.settings.seed = static_cast<std::uint32_t>(seed);
      const Vec3 all = render_scene(with_light_rays(scene, 0), settings).mean();
      const Vec3 chosen = render_scene(with_light_rays(scene, rays), settings).mean();
      const double difference = chosen.x + chosen.y + chosen.z - (all.x + all.y + all.z);
      whole += all.x + all.y + all.z;
      sum += difference;
      squares += difference * difference;
    }
    const double mean = sum / seeds, error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
    EXPECT_GT(error, 0) << "nothing was chosen";
    EXPECT_LT(error, 0.03 * whole / seeds) << "too noisy to tell";
    // Four standard deviations: fewer than one in 700 runs of all scenes, and the seeds are fixed.
    EXPECT_LT(std::abs(mean), 4 * error) << number;
  }
}

// As many samples as a cluster has lights look at each of them once: nothing is left to chance.
TEST(LightRays, OfAPixelMissNoLight) {
  std::string text = "image_size 8 8\nfov 50\nrays_per_pixel 16\n";
  RandomNumbers r(3);
  for (int i = 0; i < 64; i++) {
    text += fmt::format("light {} {} {} {} {} {}\n", r.between(-5, 5), r.between(1, 4), r.between(-5, 2),
                        r.between(0.005, 0.02), r.between(0.005, 0.02), r.between(0.005, 0.02));
  }
  text += "diffuse 1 1 1 0 0 0\nbegin\nvertex -90 -1 50\nvertex 90 -1 50\nvertex 0 -1 -90\nend\nsphere 1 0 0 -5\n";
  Scene scene = scene_from(text);
  scene.settings.antialiasing = false;
  const Picture3 all = render_scene(with_light_rays(scene, 0)), chosen = render_scene(with_light_rays(scene, 4));
  EXPECT_EQ(16 * chosen.rays[RayKind::shadow], all.rays[RayKind::shadow]);
  for (int y = 0; y < 8; y++) {
    for (int x = 0; x < 8; x++) EXPECT_NEAR(length(chosen.at(x, y) - all.at(x, y)), 0, 2e-6);
  }
}

TEST(LightRays, AreCountedInAll) {
  // All lights shine on all that the eye sees: a floor.
  std::string text = "image_size 5 5\nfov 20\neye 0 3 0\nuvw 1 0 0 0 0 -1 0 1 0\nrays_per_pixel 3\n";
  RandomNumbers r(8);
  for (int i = 0; i < 300; i++) {
    text += fmt::format("light {} {} {} 0.01 0.01 0.01\n", r.between(-5, 5), r.between(1, 4), r.between(-5, 2));
  }
  text += "diffuse 1 1 1 0 0 0\nbegin\nvertex -90 -1 50\nvertex 90 -1 50\nvertex 0 -1 -90\nend\n";
  const Scene scene = scene_from(text);
  for (const int rays : {1, 2, 3, 7, 20, 24, 64, 299}) {
    EXPECT_EQ(render_scene(with_light_rays(scene, rays)).rays[RayKind::shadow], 75u * static_cast<unsigned>(rays));
  }
  EXPECT_EQ(render_scene(with_light_rays(scene, 300)).rays[RayKind::shadow], 75u * 300u);
}

TEST(LightRays, GoToAllLightsWhereThereAreFewOrNothingAverages) {
  Scene few = scene_from(random_lights(1, 8)), many = scene_from(random_lights(1, 100));
  EXPECT_EQ(chosen_light_rays(few), 0);
  EXPECT_GT(chosen_light_rays(many), 0);
  many.settings.rays_per_pixel = 1;
  EXPECT_EQ(chosen_light_rays(many), 0);
  many.settings.rays_per_pixel = 4;
  many.settings.course = Course::any_year;
  EXPECT_EQ(chosen_light_rays(many), 0);
  many.settings.light_rays = 5;
  EXPECT_EQ(chosen_light_rays(many), 5);
  few.settings.light_rays = 8;
  EXPECT_EQ(chosen_light_rays(few), 0) << "as many rays as lights: each has its own";
}

TEST(LightClusters, HoldEachLightOnce) {
  for (const int lights : {9, 64, 100, 257, 3000, 20'000}) {
    const Frame frame = frame_from(scene_from(random_lights(5, lights)));
    for (const int rays : {1, 3, 8, 24, 100}) {
      if (rays >= lights) continue;
      const LightClusters made = make_light_clusters(frame.lights, rays);
      EXPECT_TRUE(
          made.clusters.size() == static_cast<std::size_t>(rays) ||
          (made.clusters.size() > static_cast<std::size_t>(rays) && made.clusters.size() <= LightClusters::most))
          << lights << ' ' << rays << ' ' << made.clusters.size();
      std::vector<std::uint32_t> numbers = made.lights;
      std::ranges::sort(numbers);
      std::vector<std::uint32_t> all(static_cast<std::size_t>(lights));
      std::iota(all.begin(), all.end(), 0u);
      EXPECT_EQ(numbers, all);
      std::uint32_t next = 0;
      for (const LightCluster& cluster : made.clusters) {
        EXPECT_EQ(cluster.first, next);
        EXPECT_TRUE(std::has_single_bit(cluster.count));
        next += cluster.count;
      }
      EXPECT_EQ(next, all.size());
    }
  }
}

// One light that outshines the others has a cluster of its own.
TEST(LightClusters, LeaveABrightLightAlone) {
  Scene scene = scene_from(random_lights(2, 100));
  scene.lights[31] = PointLight{{0, 3, -4}, {50, 50, 50}};
  const Frame frame = frame_from(scene);
  const LightClusters made = make_light_clusters(frame.lights, 4);
  const auto alone = std::ranges::find(made.clusters, 1u, &LightCluster::count);
  ASSERT_NE(alone, made.clusters.end());
  EXPECT_EQ(made.lights[alone->first], 31u);
}

}  // namespace
}  // namespace penumbra::test
