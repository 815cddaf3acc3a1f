// Mirrors: the recursion against the geometric series, what a missed reflection sees, and which way mirrors face.
#include <gtest/gtest.h>

#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

TEST(Mirrors, TwoParallelOnesGiveTheGeometricSeries) {
  for (const int depth : {0, 1, 2, 3, 8, 20}) {
    const std::string text = look({}, {0, 0, -1}) + fmt::format("max_depth {}\n", depth) +
                             "reflective 0 0 0 0.5 0.25 1 0.75\nbox -9 -9 -3 9 9 -2\n"
                             "reflective 0 0 0 0.1 0.2 0 0.5\nbox -9 -9 2 9 9 3\n";
    Vec3 expected, factor{1, 1, 1};
    for (int bounce = 0; bounce <= depth; bounce++) {
      const bool far = bounce % 2 == 0;
      const Vec3 ambient = far ? Vec3{0.5, 0.25, 1} : Vec3{0.1, 0.2, 0};
      expected = expected + Vec3{factor.x * ambient.x, factor.y * ambient.y, factor.z * ambient.z};
      factor = factor * (far ? 0.75 : 0.5);
    }
    expect_color(color_of(text), expected, 1e-5);
  }
}

// Factors of 1 and more are plain factors too.
TEST(Mirrors, NothingIsNormalisedOrClamped) {
  const std::string text =
      look({}, {0, 0, -1}) + "max_depth 3\nreflective 0 0 0 1 1 1 2\nbox -9 -9 -3 9 9 -2\nbox -9 -9 2 9 9 3\n";
  expect_color(color_of(text), {15, 15, 15}, 1e-4);
}

TEST(Mirrors, MissedReflectionsSeeTheBackground) {
  const std::string text =
      look({}, {0, -1, -1}) + "background 0.2 0.4 0.8\nreflective 0 0 0 0.1 0 0 0.5\nbox -9 -3 -9 9 -2 9\n";
  expect_color(color_of(text), {0.2, 0.2, 0.4}, 1e-6);
  // At the last depth not even the background.
  expect_color(color_of("max_depth 0\n" + text), {0.1, 0, 0}, 1e-6);
}

TEST(Mirrors, DirectionIsTheMirrorDirection) {
  const Vec3 eye{0, 1, 0}, direction = normalize({1, -2, 0.5});
  for (const std::string floor :
       {"box -50 -1 -50 50 0 50\n", "begin\nvertex -50 0 -50\nvertex 0 0 90\nvertex 60 0 -50\nend\n",
        "begin\nvertex 60 0 -50\nvertex 0 0 90\nvertex -50 0 -50\nend\n", "sphere 400 0 -400 0\n"}) {
    const std::string text = look(eye, direction) + "reflective 0 0 0 0 0 0 1\n" + floor + environment({1, 1, 1});
    Vec3 hit = eye + direction * (1 / -direction.y);
    Vec3 normal{0, 1, 0};
    if (floor[0] == 's') {
      const Vec3 from = eye - Vec3{0, -400, 0};
      const double b = dot(from, direction);
      hit = eye + direction * (-b - std::sqrt(b * b - dot(from, from) + 160000));
      normal = (hit - Vec3{0, -400, 0}) / 400;
    }
    const Vec3 mirrored = direction - normal * (2 * dot(direction, normal));
    expect_color(color_of(text, without_shadows()), seen_normal(hit, mirrored), 2e-4);
  }
}

// Inside a ball the mirror faces inward, though its shading normal points outward.
TEST(Mirrors, InsideOfABallReflects) {
  const Vec3 direction = normalize({0.6, 0, -0.8});
  const std::string text =
      look({0, 0, -1}, direction) + "max_depth 1\nreflective 0 0 0 0.25 0.25 0.25 0.5\nsphere 2 0 0 0\n";
  expect_color(color_of(text), {0.375, 0.375, 0.375}, 1e-6);
}

}  // namespace
}  // namespace penumbra::test
