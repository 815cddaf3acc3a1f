// Where surfaces reflect and transmit, one of the two rays is chosen where both are worth little.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/test_scale.hpp"
#include "rendering/film_values.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

// Balls of glass in front of each other and a mirror, lights above; some of them frosted.
std::string random_glass(int number, int depth) {
  std::mt19937 random(static_cast<std::uint32_t>(number));
  const auto between = [&](double low, double high) { return low + (high - low) * (random() >> 8) / double{1 << 24}; };
  std::string text = fmt::format(
      "image_size 6 6\nfov 40\nrays_per_pixel 4\nmax_depth {}\nbackground {} {} {}\nlight {} 5 2 0.6 0.5 0.4\n"
      "disk_light {} 6 -3 1 0 -1 0 0.4 0.5 0.6\nsurface 0.4 0.4 0.3 0.05 0.05 0.05 0 0 0 1 0.4\n"
      "begin\nvertex -30 -2 20\nvertex 30 -2 20\nvertex 0 -2 -60\nend\n",
      depth, between(0, 0.5), between(0, 0.5), between(0, 0.5), between(-3, 3), between(-3, 3));
  for (int i = 0; i < 6; i++) {
    const double transmission = between(0.3, 0.9);
    text += fmt::format("translucent 0.1 0.1 0.1 0.2 0.2 0.2 20 {} {} {} {} {}\nsphere {} {} {} {}\n",
                        between(0.05, 1 - transmission), number % 2 ? between(0, 0.2) : 0, transmission,
                        between(1.1, 1.7), number % 2 ? between(0, 0.2) : 0, between(0.5, 1.2), between(-1.2, 1.2),
                        between(-1, 1.2), between(-8, -4));
  }
  return text;
}

Scene with_branching(Scene scene, Branching branching) {
  scene.settings.branching = branching;
  return scene;
}

TEST(Branching, KeepsTheMean) {
  constexpr int scenes = scaled(20, 4), seeds = 64;
  for (int number = 0; number < scenes; number++) {
    Scene scene = scene_from(random_glass(number, 7));
    double sum = 0, squares = 0, whole = 0;
    for (int seed = 0; seed < seeds; seed++) {
      scene.settings.seed = static_cast<std::uint32_t>(seed);
      const Vec3 full = render_scene(with_branching(scene, Branching::full)).mean();
      const Vec3 chosen = render_scene(with_branching(scene, Branching::automatic)).mean();
      const double difference = chosen.x + chosen.y + chosen.z - (full.x + full.y + full.z);
      whole += full.x + full.y + full.z;
      sum += difference;
      squares += difference * difference;
    }
    const double mean = sum / seeds, error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
    EXPECT_GT(error, 0) << "nothing was chosen";
    EXPECT_LT(error, 0.005 * whole / seeds) << "too noisy to tell";
    // Four standard deviations: fewer than one in 700 runs of all scenes, and the seeds are fixed.
    EXPECT_LT(std::abs(mean), 4 * error) << number;
  }
}

TEST(Branching, ChangesNothingWhereNoRayHasBoth) {
  const std::string mirrors_and_sheets =
      "image_size 20 20\nrays_per_pixel 5\nlight 3 5 2 1 1 1\nsurface 0.2 0.2 0.2 0 0 0 0 0 0 1 0.8\nsphere 1 -1 0 -5\n"
      "translucent 0.2 0.2 0.2 0 0 0 1 0 0 0.8 1.5 0.1\nsphere 1 1 0 -5\n";
  const Scene scene = scene_from(mirrors_and_sheets);
  EXPECT_TRUE(values_of(render_scene(with_branching(scene, Branching::full)).film) ==
              values_of(render_scene(with_branching(scene, Branching::automatic)).film));
}

// One ray per pixel has no others that average what it leaves out; the pictures of the course have whole trees.
TEST(Branching, IsFullForSingleRaysAndTheCourse) {
  Scene scene = scene_from(random_glass(1, 7));
  EXPECT_TRUE(chooses_branches(scene));
  scene.settings.rays_per_pixel = 1;
  EXPECT_FALSE(chooses_branches(scene));
  scene.settings.rays_per_pixel = 2;
  scene.settings.course = Course::any_year;
  EXPECT_FALSE(chooses_branches(scene));
}

// Whole trees double with each depth; chosen ones hardly grow.
TEST(Branching, DeepTreesCostLittle) {
  const auto rays = [](int depth, Branching branching) {
    return static_cast<double>(
        render_scene(with_branching(scene_from(random_glass(4, depth)), branching)).rays.total());
  };
  EXPECT_GT(rays(14, Branching::full), 3 * rays(7, Branching::full));
  EXPECT_LT(rays(14, Branching::automatic), 1.5 * rays(7, Branching::automatic));
  EXPECT_LT(rays(100, Branching::automatic), 4 * rays(7, Branching::automatic));
}

// Whichever rays wait together: a pixel alone is the same pixel of the whole picture.
TEST(Branching, OtherPixelsDoNotShow) {
  const Scene scene = scene_from(random_glass(3, 9));
  const Picture3 whole = render_scene(scene);
  for (const auto& [x, y] : {std::pair{0, 0}, {3, 2}, {5, 5}}) {
    RenderSettings settings;
    settings.crop = PixelRect{x, y, x + 1, y + 1};
    EXPECT_EQ(render_scene(scene, settings).at(x, y), whole.at(x, y));
  }
}

}  // namespace
}  // namespace penumbra::test
