// Several rays from the hit of an eye ray: how many are sent, that their mean is what one ray would give, and that they
// are stratified among themselves, which is what the lecture's 10, 20 and 50 rays are for.
#include <gtest/gtest.h>

#include <set>

#include "base/test_scale.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

constexpr Pattern all_patterns[] = {Pattern::regular, Pattern::random, Pattern::jittered, Pattern::multijittered,
                                    Pattern::poisson, Pattern::halton, Pattern::sobol,    Pattern::bluenoise};

// Three eye rays fall on a mirror, which shows a mirror, under a disk light and a point light.
const std::string two_mirrors = look({0, 0, 0}, {0, 0, -1}) + R"(rays_per_pixel 3
max_depth 2
disk_light 0 5 -2.5 0.1 0 1 0 1 1 1
light 0 5 -2.5 1 1 1
glossy 1 1 1 0 0 0 1 0.5 0.001
box -9 -9 -6 9 9 -5
box -9 -9 5 9 9 6
)";

TEST(RaysOfAHit, AreCounted) {
  const RayCounts one = render_text(two_mirrors).rays;
  EXPECT_EQ(one[RayKind::eye], 3u);
  EXPECT_EQ(one[RayKind::reflection], 3u + 3u);
  EXPECT_EQ(one[RayKind::shadow], 3u * 3u * 2u);
  const RayCounts ten = render_text("reflection_rays 10\n" + two_mirrors).rays;
  EXPECT_EQ(ten[RayKind::reflection], 3u * 10u + 3u * 10u) << "each of the ten sends one on";
  EXPECT_EQ(ten[RayKind::shadow], 3u * 2u * (1u + 10u + 10u));
  const RayCounts shadows = render_text("shadow_rays 7\n" + two_mirrors).rays;
  EXPECT_EQ(shadows[RayKind::shadow], 3u * (7u + 1u) + 2u * 3u * 2u) << "to the disk only, and from the first hit only";
  const std::string sheet = look({0, 0, 0}, {0, 0, -1}) + R"(rays_per_pixel 3
translucent 1 1 1 0 0 0 1 0 0 0.5 1 0.1
box -9 -9 -6 9 9 -5
)";
  EXPECT_EQ(render_text("transmission_rays 5\n" + sheet).rays[RayKind::transmission], 3u * 5u + 3u * 5u);
}

// A blurred mirror and a blurred sheet in an environment of smoothly varying colour, and a half-covered disk light.
const std::string blurred = R"(translucent 0 0 0 0 0 0 1 0.5 0.6 0.5 1 0.5
begin
vertex -9 -9 -3
vertex 9 -9 -3
vertex 0 18 -3
end
)";
const std::string soft_shadow = R"(disk_light 0 10 0 2 0 -1 0 1 1 1
surface 1 1 1
box -99 -1 -99 99 0 99
box -99 4 -99 0 4.001 99
)";

std::string rays_of_hit(int rays) {
  return fmt::format("reflection_rays {0}\ntransmission_rays {0}\nshadow_rays {0}\n", rays);
}

struct Estimate {
  double mean, variance;
};

// Over as many pixels as there are seeds: one eye ray each.
Estimate estimate(const std::string& scene, RenderSettings settings, int rays, int seeds) {
  double sum = 0, squares = 0;
  Scene read = scene_from(scene + rays_of_hit(rays), settings);
  for (int seed = 0; seed < seeds; seed++) {
    read.settings.seed = static_cast<std::uint32_t>(seed);
    const double value = render_scene(read, settings).at(0, 0).x;
    sum += value;
    squares += value * value;
  }
  const double mean = sum / seeds;
  return {mean, (squares / seeds - mean * mean) * seeds / (seeds - 1)};
}

struct BlurredThing {
  std::string text;
  RenderSettings settings;
};

std::vector<BlurredThing> blurred_things() {
  return {{look({0, 0, 0}, {0, 0, -1}) + blurred + environment({1, 1, 1}), without_shadows()},
          {look({0.1, 2, 0}, {0, -1, 0}) + soft_shadow, {}}};
}

TEST(RaysOfAHit, KeepTheMeanAndAreStratified) {
  constexpr int seeds = scaled(1500, 200);
  for (const BlurredThing& thing : blurred_things()) {
    RenderSettings settings = thing.settings;
    settings.pattern = Pattern::random;
    const Estimate one = estimate(thing.text, settings, 1, 4 * seeds);
    for (const Pattern pattern : all_patterns) {
      if (pattern == Pattern::regular) continue;
      settings.pattern = pattern;
      const Estimate many = estimate(thing.text, settings, 16, seeds);
      const std::string name(pattern_names[static_cast<int>(pattern)]);
      // Six standard deviations: fewer than one seed in a million over all patterns.
      EXPECT_NEAR(many.mean, one.mean, 6 * std::sqrt(one.variance / (4 * seeds) + many.variance / seeds)) << name;
      // The variance of 1500 values is known to within 20 % at six standard deviations of a normal one.
      if (pattern == Pattern::random) {
        EXPECT_NEAR(many.variance, one.variance / 16, 0.3 * one.variance / 16);
      } else {
        EXPECT_LT(many.variance, one.variance / 16 * 0.6) << name;
      }
    }
  }
}

// Seven eye rays with seven shadow rays each have to be better than seven with one.
TEST(RaysOfAHit, AddToTheRaysOfThePixel) {
  const std::string scene = look({0.1, 2, 0}, {0, -1, 0}) + soft_shadow + "rays_per_pixel 7\n";
  for (const Pattern pattern : all_patterns) {
    if (pattern == Pattern::regular) continue;
    RenderSettings settings;
    settings.pattern = pattern;
    const Estimate one = estimate(scene, settings, 1, scaled(400, 100));
    const Estimate seven = estimate(scene, settings, 7, scaled(400, 100));
    EXPECT_LT(seven.variance, one.variance / 3) << pattern_names[static_cast<int>(pattern)];
  }
}

// The page "visible penumbra and umbra, but too distinct": all pixels see the same few points of the light, so that a
// floor far below it shows no more shades than there are points, whatever pattern and seed; and the picture has no
// noise at all.
TEST(RegularLights, GiveAsManyShadesAsPoints) {
  const std::string scene = R"(image_size 60 5
fov 40
eye 0 2 0
uvw 1 0 0 0 0 -1 0 1 0
disk_light 0 100000 0 20000 0 -1 0 1 1 1
surface 1 1 1
box -99 -1 -99 99 0 99
box -99 2.5 -99 0 2.6 99
shadow_rays 10
)";
  RenderSettings settings;
  settings.regular_lights = true;
  const Picture3 first = render_text(scene, settings);
  std::set<int> shades;
  for (int x = 0; x < 60; x++) {
    for (int y = 0; y < 5; y++) {
      EXPECT_NEAR(first.at(x, y).x, first.at(x, 0).x, 1e-4) << "no noise from row to row";
      shades.insert(static_cast<int>(std::lround(first.at(x, y).x * 20)));  // N.L is within 0.02 of one
    }
  }
  EXPECT_GE(shades.size(), 5u);
  EXPECT_LE(shades.size(), 11u);
  settings.pattern = Pattern::random;
  EXPECT_EQ(render_text("seed 5\n" + scene, settings).color, first.color);
  settings.regular_lights = false;
  EXPECT_NE(render_text(scene, settings).color, first.color);
}

}  // namespace
}  // namespace penumbra::test
