// Point lights and spotlights at known points, the ambient part, and which side of a surface is lit.
#include <gtest/gtest.h>

#include <numbers>

#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

const std::string floor_box = "box -20 -1 -20 20 0 20\n";

TEST(Lights, PointLightHasNoFalloff) {
  for (const double size : {1.0, 10.0, 1000.0}) {
    const Vec3 light = Vec3{1, 2, -2} * size;
    const std::string text = look({0, 3, 4}, {0, -3, -4}) + fmt::format("light {} 0.9 0.6 0.3\n", numbers(light)) +
                             "diffuse 0.5 1 2 0 0 0\n" + floor_box;
    expect_color(color_of(text), Vec3{0.45, 0.6, 0.6} * (2.0 / 3), 2e-5);
  }
}

TEST(Lights, AmbientIsAddedOnce) {
  std::string text = look({0, 3, 4}, {0, -3, -4}) + "diffuse 0.5 0.5 0.5 0.1 0.2 0.3\n" + floor_box;
  expect_color(color_of(text), {0.1, 0.2, 0.3}, 1e-6);
  for (int lights = 1; lights <= 5; lights++) {
    text += "light 0 7 0 0.2 0.2 0.2\n";
    const double d = 0.1 * lights;
    expect_color(color_of(text), {0.1 + d, 0.2 + d, 0.3 + d}, 1e-5);
  }
}

// A ceiling above a lamp does not darken the floor below it.
TEST(Lights, WhatLiesBeyondThemCastsNoShadow) {
  const std::string ceiling = "box -20 6 -20 20 7 20\n";
  for (const char* lamp : {"light 0 3 0 1 1 1\n", "spotlight 0 3 0 0 -1 0 40 50 1 1 1\n",
                           "disk_light 0 3 0 0.5 0 1 0 1 1 1\n", "quad_light 0 3 0 0.5 0 0 0 0 0.5 1 1 1\n"}) {
    const std::string text = look({0, 1, 4}, {0, -1, -4}) + lamp + "surface 1 1 1\n" + floor_box;
    const Vec3 open = color_of(text);
    EXPECT_GT(open.x, 0.9) << lamp;
    EXPECT_EQ(color_of(text + ceiling), open) << lamp;
  }
}

TEST(Lights, SpotlightIsASmoothstepOfCosines) {
  // Over the origin, straight down: the angle at the floor point (x, 0, 0) is atan(x / 4).
  const double inner = 15, outer = 40;
  const auto cosine_of = [](double degrees) { return std::cos(degrees * std::numbers::pi / 180); };
  for (const double degrees : {0.0, 5.0, 14.9, 15.1, 20.0, 27.5, 33.0, 39.5, 40.5, 60.0}) {
    const double x = 4 * std::tan(degrees * std::numbers::pi / 180);
    const std::string text = look({x, 3, 0}, {0, -1, 0}) +
                             fmt::format("spotlight 0 4 0 0 -2 0 {} {} 1 0.5 2\nsurface 1 1 1\n", inner, outer) +
                             floor_box;
    const double t = (cosine_of(degrees) - cosine_of(outer)) / (cosine_of(inner) - cosine_of(outer));
    const double u = std::clamp(t, 0.0, 1.0);
    const double expected = u * u * (3 - 2 * u) * cosine_of(degrees);
    expect_color(color_of(text), Vec3{1, 0.5, 2} * expected, 5e-5);
  }
}

TEST(Lights, SpotlightWithoutSoftEdge) {
  for (const double degrees : {0.0, 29.0, 31.0, 80.0}) {
    const double x = 4 * std::tan(degrees * std::numbers::pi / 180);
    const std::string text =
        look({x, 3, 0}, {0, -1, 0}) + "spotlight 0 4 0 0 -1 0 30 30 1 1 1\nsurface 1 1 1\n" + floor_box;
    const double expected = degrees < 30 ? std::cos(degrees * std::numbers::pi / 180) : 0;
    expect_color(color_of(text), Vec3{1, 1, 1} * expected, 5e-5);
  }
}

// Lights stay where they are, whatever the matrix; so does the eye.
TEST(Lights, AreNotMovedByTheMatrix) {
  const std::string text =
      "translate 5 5 5\nrotate 50 1 2 3\nlight 0 4 0 1 1 1\n" + look({0, 3, 0}, {0, -1, 0}) + "pop\npush\n" + floor_box;
  const std::string pushed = "push\n" + text;
  expect_color(color_of(pushed), {1, 1, 1}, 1e-5);
}

TEST(Lights, TrianglesAreLitFromBothSidesAndSolidsFromOutside) {
  const std::string light = "light 0 2 0 1 1 1\n";
  const std::string up = "begin\nvertex -9 0 -9\nvertex 0 0 9\nvertex 9 0 -9\nend\n";
  const std::string down = "begin\nvertex 9 0 -9\nvertex 0 0 9\nvertex -9 0 -9\nend\n";
  for (const std::string& triangle : {up, down}) {
    expect_color(color_of(look({0, 1, 0}, {0, -1, 0}) + light + triangle), {1, 1, 1}, 1e-5);
    // Light and eye on different sides.
    expect_color(color_of(look({0, -1, 0}, {0, 1, 0}) + light + triangle), {}, 0);
    expect_color(color_of(look({0, -1, 0}, {0, 1, 0}) + light + triangle, without_shadows()), {}, 0);
  }
  // Eye and light inside a ball or a box: its normal points away from both.
  expect_color(color_of(look({0, 1, 0}, {0, -1, 0}) + light + "sphere 4 0 0 0\n"), {}, 0);
  expect_color(color_of(look({0, 1, 0}, {0, -1, 0}) + light + "box -4 -4 -4 4 4 4\n"), {}, 0);
}

TEST(Lights, DiskShinesToBothSidesWithoutCosine) {
  // Small enough to be a point; its axis is across the way to the floor, then along it, then against it.
  for (const std::string axis : {"1 0.001 0", "0 1 0", "0 -1 0", "0 0 7"}) {
    const std::string text =
        look({0, 3, 0}, {0, -1, 0}) + "disk_light 0 4 0 0.0001 " + axis + " 0.5 1 2\nsurface 1 1 1\n" + floor_box;
    expect_color(color_of(text), {0.5, 1, 2}, 1e-4);
  }
}

}  // namespace
}  // namespace penumbra::test
