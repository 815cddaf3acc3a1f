// Gloss and blur: mean and variance of the spread directions against a numeric integral over the ball, with folding at
// the surface; and energy, which spreading never changes. 2^16 samples against 4 10^5 of the integral: limits are five
// standard errors of both, one seed in 10^6.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "base/test_scale.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

constexpr int rays = scaled(65536, 4096);
constexpr int integral_points = scaled(400000, 50000);

struct Moments {
  Vec3 mean, variance;
};

// Of what the environment shows of unit(direction + ball), folded to the side that `side` points to.
Moments integrate(Vec3 hit, Vec3 direction, double radius, Vec3 side, Vec3 signs) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  Vec3 sum, squares;
  for (int i = 0; i < integral_points;) {
    const double bx = number(random), by = number(random), bz = number(random);
    if (bx * bx + by * by + bz * bz > 1) continue;
    i++;
    Vec3 d = direction + Vec3{bx, by, bz} * radius;
    if (dot(d, side) < 0) d = d - side * (2 * dot(d, side));
    const Vec3 n = seen_normal(hit, normalize(d));
    const Vec3 seen = max({n.x * signs.x, n.y * signs.y, n.z * signs.z}, {});
    sum = sum + seen;
    squares = squares + Vec3{seen.x * seen.x, seen.y * seen.y, seen.z * seen.z};
  }
  const Vec3 mean = sum / integral_points;
  const Vec3 square = squares / integral_points;
  return {mean, square - Vec3{mean.x * mean.x, mean.y * mean.y, mean.z * mean.z}};
}

void check(const std::string& text, Vec3 hit, Vec3 direction, double radius, Vec3 side) {
  for (const Vec3 signs : {Vec3{1, 1, 1}, Vec3{-1, -1, -1}}) {
    const Moments expected = integrate(hit, direction, radius, side, signs);
    for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
      RenderSettings settings = without_shadows();
      settings.pattern = pattern;
      settings.layers = {Layer::variance};
      const Picture3 picture = render_text(text + environment(signs), settings);
      const ZeroedVector<float> variances = picture.film.layer(Layer::variance);
      for (int c = 0; c < 3; c++) {
        // No number differs by more than 1 from the mean: its square varies no more than itself.
        const double variance = expected.variance[c];
        const double error = 5 * std::sqrt(variance * (1.0 / rays + 1.0 / integral_points)) + 1e-4;
        EXPECT_NEAR(picture.at(0, 0)[c], expected.mean[c], error) << "radius " << radius << " channel " << c;
        EXPECT_NEAR(variances[static_cast<std::size_t>(c)] * rays, variance, error) << "radius " << radius;
      }
    }
  }
}

const std::string floor_sheet = "begin\nvertex -50 0 -50\nvertex 0 0 90\nvertex 60 0 -50\nend\n";
const std::string many_rays = fmt::format("rays_per_pixel {}\n", rays);

TEST(Spread, GlossBall) {
  for (const double height : {2.0, 0.3}) {  // from high above, and grazing, where half of the ball is folded back
    const Vec3 direction = normalize({1, -height, 0.4});
    const Vec3 mirrored{direction.x, -direction.y, direction.z};
    for (const double radius : {0.05, 0.3, 0.9}) {
      const std::string text = look(-direction * 2, direction) + many_rays +
                               fmt::format("glossy 0 0 0 0 0 0 1 1 {}\n", radius) + floor_sheet;
      check(text, {}, mirrored, radius, {0, 1, 0});
    }
  }
}

TEST(Spread, BlurBall) {
  for (const double height : {2.0, 0.3}) {
    const Vec3 direction = normalize({1, -height, 0.4});
    for (const double radius : {0.05, 0.3, 0.9}) {
      const std::string text = look(-direction * 2, direction) + many_rays +
                               fmt::format("translucent 0 0 0 0 0 0 1 0 0 1 1 {}\n", radius) + floor_sheet;
      check(text, {}, direction, radius, {0, -1, 0});
    }
  }
}

// Whatever the radius, even beyond 1, no ray gets lost and none goes to the wrong side: all see the same bright ball
// above, none the black floor's other side.
TEST(Spread, EnergyAndSide) {
  for (const double radius : {0.01, 0.5, 1.0, 3.0, 50.0}) {
    for (const double height : {2.0, 0.02}) {
      const Vec3 direction = normalize({1, -height, 0.4});
      const std::string camera =
          look(-direction * 2, direction) + fmt::format("rays_per_pixel {}\n", scaled(4096, 512));
      // The half space above is bright, that below dark: the plate is a box that fills it.
      const std::string bright = "background 1 1 1\n";
      const std::string dark = "surface 0 0 0\nbox -900 -900 -900 900 -0.01 900\n";
      expect_color(color_of(camera + bright + fmt::format("glossy 0 0 0 0 0 0 1 1 {}\n", radius) + floor_sheet + dark),
                   {1, 1, 1}, 1e-6);
      const std::string dark_above = "surface 0 0 0\nbox -900 0.5 -900 900 900 900\n";
      const Vec3 low_eye = -direction * (0.2 / std::max(-direction.y, 0.1));
      expect_color(color_of(look(low_eye, direction) + fmt::format("rays_per_pixel {}\n", scaled(4096, 512)) + bright +
                            fmt::format("translucent 0 0 0 0 0 0 1 0 0 1 1 {}\n", radius) + floor_sheet + dark_above),
                   {1, 1, 1}, 1e-6);
    }
  }
}

TEST(Spread, RadiusZeroIsSharp) {
  const Vec3 direction = normalize({1, -2, 0.4});
  const std::string camera = look(-direction * 2, direction) + "rays_per_pixel 16\n";
  const Vec3 mirrored{direction.x, -direction.y, direction.z};
  expect_color(
      color_of(camera + "glossy 0 0 0 0 0 0 1 1 0\n" + floor_sheet + environment({1, 1, 1}), without_shadows()),
      seen_normal({}, mirrored), 1e-4);
}

}  // namespace
}  // namespace penumbra::test
