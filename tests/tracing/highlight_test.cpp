// The two highlight formulas at known points: max(0, R.V)^p and max(0, N.H)^p, in the light and not, from the front and
// not, with V towards where the ray came from.
#include <gtest/gtest.h>

#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

const std::string phong = "highlight phong\nsurface 0 0 0 0 0 0 0.5 0.25 1 {} 0\n";
const std::string blinn = "glossy 0 0 0 0.5 0.25 1 {} 0 0\n";
const std::string floor_box = "box -20 -1 -20 20 0 20\n";

// The highlight at the origin of the floor y = 0.
double expected_highlight(bool is_blinn, Vec3 light, Vec3 eye, double power) {
  const Vec3 n{0, 1, 0}, l = normalize(light), v = normalize(eye);
  const double cosine = is_blinn ? dot(n, normalize(l + v)) : dot(n * (2 * dot(n, l)) - l, v);
  return std::pow(std::max(cosine, 0.0), power);
}

TEST(Highlight, MatchesTheFormulas) {
  const Vec3 eye{1, 2, 3};
  for (const bool is_blinn : {false, true}) {
    for (const double power : {1.0, 2.0, 7.5, 50.0, 300.0}) {
      for (const Vec3 light : {Vec3{-1, 2, -3}, Vec3{-1, 2, -2}, Vec3{2, 2, -1}, Vec3{4, 0.5, 4}, Vec3{0, 5, 0}}) {
        const std::string text = look(eye, -eye) + fmt::format("light {} 1 1 2\n", numbers(light)) +
                                 fmt::format(fmt::runtime(is_blinn ? blinn : phong), power) + floor_box;
        const double h = expected_highlight(is_blinn, light, eye, power);
        expect_color(color_of(text), {0.5 * h, 0.25 * h, 2 * h}, 2e-6 * power + 2e-5);
      }
    }
  }
}

TEST(Highlight, IsShadowedLikeTheDiffusePart) {
  const std::string ball = "surface 0 0 0\nsphere 0.2 -0.5 1 -1.5\n";
  for (const std::string& form : {phong, blinn}) {
    const std::string text =
        look({1, 2, 3}, {-1, -2, -3}) + "light -1 2 -3 1 1 1\n" + fmt::format(fmt::runtime(form), 5) + floor_box;
    EXPECT_GT(color_of(text).z, 0.99);
    expect_color(color_of(text + ball), {}, 0);
  }
}

// Not gated by N.L > 0: a light just below the horizon still has N.H > 0. Its shadow ray is stopped by the floor
// itself, so that this shows without shadows only.
TEST(Highlight, IsNotGatedByTheDiffuseCosine) {
  const Vec3 eye{1, 2, 3}, light{-1, -0.5, -3};
  const std::string text = look(eye, -eye) + fmt::format("light {} 1 1 1\n", numbers(light)) +
                           fmt::format(fmt::runtime(blinn), 3) + floor_box;
  const double h = expected_highlight(true, light, eye, 3);
  ASSERT_GT(h, 0.001);
  expect_color(color_of(text, without_shadows()), {0.5 * h, 0.25 * h, h}, 1e-5);
  expect_color(color_of(text), {}, 0);
}

// Seen in a mirror, V points to the mirror and not to the eye.
TEST(Highlight, UsesTheRayAndNotTheEye) {
  // Down to a mirror at y = -3 and up again to the underside of a plate at y = 0, at the origin.
  const Vec3 mirrored_eye{1, -8, 2};  // where the eye at y = 2 appears below the mirror
  const std::string text = look({1, 2, 2}, Vec3{-1, -8, -2}) + "light -2 -2.5 1 1 1 1\n" +
                           fmt::format(fmt::runtime(phong), 4) + "box -0.2 0 -0.2 0.2 1 0.2\n" +
                           "reflective 0 0 0 0 0 0 0.5\nbox -50 -4 -50 50 -3 50\n";
  const Vec3 n{0, -1, 0}, l = normalize({-2, -2.5, 1}), v = normalize(mirrored_eye);
  const double h = std::pow(std::max(dot(n * (2 * dot(n, l)) - l, v), 0.0), 4);
  ASSERT_GT(h, 0.05);
  expect_color(color_of(text), Vec3{0.5, 0.25, 1} * (0.5 * h), 1e-5);
}

}  // namespace
}  // namespace penumbra::test
