// Motion: how long a moving ball covers each pixel of a row, that one time belongs to an eye ray and all its
// descendants, and that the shutter is the one asked for. Limits are five standard deviations of independent samples.
#include <gtest/gtest.h>

#include <numbers>

#include "base/test_scale.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

constexpr int rays = scaled(4096, 256);

// A ball of radius 0.4 that passes at distance 10 from x = -3 + 6 t, over a row of pixels 40 x 1.
struct Row {
  static constexpr int width = 40;
  static constexpr double view = 0.025;  // a pixel at distance 1

  static std::string text(double open, double close, const std::string& ball) {
    return fmt::format("image_size {} 1\nfov {:.15g}\nrays_per_pixel {}\nshutter {} {}\ndiffuse 0 0 0 1 1 1\n", width,
                       2 * std::atan(view / 2) * 180 / std::numbers::pi, rays, open, close) +
           ball;
  }

  // The share of place in pixel i and time at which the ball is in the way.
  static double coverage(int i, double open, double close) {
    constexpr int steps = 64;
    double sum = 0;
    for (int k = 0; k < steps; k++) {
      for (int l = 0; l < steps; l++) {
        const double x = (i + (k + 0.5) / steps - width / 2.0) * view, y = ((l + 0.5) / steps - 0.5) * view;
        // The centre c x-axis + (0, 0, -10) is nearer than the radius to the line along (x, y, -1):
        // |c|^2 - (c.d)^2 / d^2 < r^2 is a quadratic in c.
        const double d2 = x * x + y * y + 1;
        const double a = 1 - x * x / d2, b = -10 * x / d2, c = 100 - 100 / d2 - 0.16;
        const double discriminant = b * b - a * c;
        if (discriminant <= 0) continue;
        const double from = ((-b - std::sqrt(discriminant)) / a + 3) / 6,
                     to = ((-b + std::sqrt(discriminant)) / a + 3) / 6;
        sum += std::max(0.0, std::min(to, close) - std::max(from, open)) / (close - open);
      }
    }
    return sum / (steps * steps);
  }

  static void check(double open, double close, const std::string& ball, Pattern pattern) {
    RenderSettings settings;
    settings.pattern = pattern;
    const Picture3 picture = render_text(text(open, close, ball), settings);
    for (int i = 0; i < width; i++) {
      const double expected = coverage(i, open, close);
      const double deviation = std::sqrt(expected * (1 - expected) / rays);
      EXPECT_NEAR(picture.at(i, 0).x, expected, 5 * deviation + 5e-4) << "pixel " << i << ": " << ball;
    }
  }
};

// Many objects have a hierarchy over them, whose bounds have to hold what moves at all times.
TEST(Motion, IsTheSameAmongManyObjects) {
  const std::string ball = "moving_sphere 0.4 -3 0 -10 3 0 -10\n";
  std::string others;  // behind the eye
  for (int i = 0; i < 50; i++) others += fmt::format("sphere 0.4 {} 0 10\n", 2 * i - 50);
  for (const double open : {0.0, 0.4}) {
    const Picture3 alone = render_text(Row::text(open, 1, ball));
    const Picture3 among = render_text(Row::text(open, 1, ball + others));
    for (int i = 0; i < Row::width; i++) EXPECT_EQ(among.at(i, 0), alone.at(i, 0)) << "pixel " << i;
  }
}

TEST(Motion, CoverageOfAMovingBall) {
  for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
    Row::check(0, 1, "moving_sphere 0.4 -3 0 -10 3 0 -10\n", pattern);
    Row::check(0, 1, "sphere 0.4 -3 0 -10\nmoving_object 6 0 0\n", pattern);
  }
}

TEST(Motion, EveryKindOfObjectMoves) {
  const std::string group = "begin_list\nsphere 0.4 -3 0 -10\nend_list\n";
  Row::check(0, 1, group + "moving_object 2 0 0\nmoving_object 4 0 0\n", Pattern::sobol);
  Row::check(0, 1, "sphere 0.4 0 0 0\nnamed_object it\ntranslate -3 0 -10\ninstance it\nmoving_object 6 0 0\n",
             Pattern::sobol);
  Row::check(0, 1, group + "named_object it\ninstance it\nmoving_object 6 0 0\n", Pattern::sobol);
  // Inside a named object the shift is turned and scaled by the instance's matrix.
  Row::check(0, 1,
             "begin_list\nsphere 0.2 0 0 0\nmoving_object 0 3 0\nend_list\nnamed_object it\ntranslate -3 0 -10\n"
             "rotatez -90\nscale 2 2 2\ninstance it\n",
             Pattern::sobol);
  Row::check(0, 1,
             "sphere 0.2 0 0 0\nmoving_object 0 3 0\nnamed_object it\ntranslate -3 0 -10\nrotatez -90\nscale 2 2 2\n"
             "instance it\n",
             Pattern::sobol);
}

TEST(Motion, ShutterIsTheOneAskedFor) {
  Row::check(0.25, 0.5, "moving_sphere 0.4 -3 0 -10 3 0 -10\n", Pattern::random);
  Row::check(-0.25, 1.5, "moving_sphere 0.4 -3 0 -10 3 0 -10\n", Pattern::random);
}

// A mirror and, behind the eye, a card of the same size move together: at every time, what sees the mirror sees the
// card in it. With times of their own, reflected rays would miss it mostly.
TEST(Motion, ReflectedRaysKeepTheTime) {
  const std::string text = look({0, 0, 0}, {0, 0, -1}) + fmt::format("rays_per_pixel {}\n", rays) +
                           "reflective 0 0 0 0 0 0 1\nbox -1.5 -1 -3 -0.5 1 -2\nmoving_object 5 0 0\n"
                           "diffuse 0 0 0 1 1 1\nbox -1.501 -1 2 -0.499 1 3\nmoving_object 5 0 0\n";
  EXPECT_NEAR(color_of(text).x, 0.2, 5 * std::sqrt(0.16 / rays));
}

// A convex body is never in its own light, however fast it moves: with and without shadows it looks the same to the
// bit.
TEST(Motion, ShadowRaysKeepTheTime) {
  const std::string scene =
      "image_size 40 40\nrays_per_pixel 16\nlight 0.1 0.2 0.3 1 1 1\nmoving_sphere 1 -1.5 0 -5 1.5 0 -5\n"
      "box -0.5 1.2 -5 0.5 1.6 -4\nmoving_object 1 0 0\n";
  const Picture3 shadowed = render_text(scene), plain = render_text(scene, without_shadows());
  // A light near the eye: only grazing hits may differ.
  int lit = 0, different = 0;
  for (std::size_t i = 0; i < plain.color.size(); i += 3) {
    lit += plain.color[i] > 0.05f;
    different += plain.color[i] > 0.05f && std::abs(shadowed.color[i] - plain.color[i]) > 0.01f;
  }
  EXPECT_GT(lit, 300);
  EXPECT_EQ(different, 0);
}

// A box that is between the light and the floor for a fifth of the time.
TEST(Motion, ShadowsAreThoseOfTheTimeOfTheRay) {
  const std::string text =
      look({0, 1, 4}, {0, -1, -4}) + fmt::format("rays_per_pixel {}\n", rays) +
      "light 0 10 0 1 1 1\ndiffuse 1 1 1 0 0 0\nbox -20 -1 -20 20 0 20\nbox -1.5 4 -1 -0.5 5 1\nmoving_object 5 0 0\n";
  EXPECT_NEAR(color_of(text).x, 0.8, 5 * std::sqrt(0.16 / rays));
}

TEST(Motion, TransmittedRaysKeepTheTime) {
  const std::string text =
      look({0, 0, 0}, {0, 0, -1}) + fmt::format("rays_per_pixel {}\n", rays) +
      "translucent 0 0 0 0 0 0 1 0 0 1 1 0\nbegin\nvertex -1.5 -1 -2\nvertex -0.5 -1 -2\nvertex -0.5 1 -2\n"
      "vertex -1.5 1 -2\nend\nmoving_object 5 0 0\n"
      "diffuse 0 0 0 1 1 1\nbox -1.501 -1 -4 -0.499 1 -3\nmoving_object 5 0 0\n";
  EXPECT_NEAR(color_of(text).x, 0.2, 5 * std::sqrt(0.16 / rays));
}

}  // namespace
}  // namespace penumbra::test
