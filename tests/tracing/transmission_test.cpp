// What comes through: thin sheets of index 1, glass balls, and the shadows of both with and without
// --transparent-shadows.
#include <gtest/gtest.h>

#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

std::string sheet(const std::string& surface, double y) {
  return surface + fmt::format("begin\nvertex -50 {0} -50\nvertex 0 {0} 90\nvertex 60 {0} -50\nend\n", y);
}
std::string clear(double k_trans) { return fmt::format("translucent 0 0 0 0 0 0 1 0 0 {} 1 0\n", k_trans); }

RenderSettings with_transparent_shadows() {
  RenderSettings settings;
  settings.transparent_shadows = true;
  return settings;
}

TEST(Transmission, SheetsOfIndexOneGoStraightOn) {
  const Vec3 direction = normalize({0.5, -2, 0.3});
  const std::string text =
      look({0, 5, 0}, direction) + sheet(clear(1), 2) + sheet(clear(1), 1) + environment({1, -1, 1});
  const Vec3 normal = seen_normal({0, 5, 0}, direction);
  expect_color(color_of(text, without_shadows()), abs(normal), 1e-4);
}

TEST(Transmission, FactorsMultiply) {
  const std::string camera = look({0, 5, 0}, {0.1, -2, 0.3}) + "background 1 0.5 0.25\n";
  expect_color(color_of(camera + sheet(clear(0.5), 2)), {0.5, 0.25, 0.125}, 1e-6);
  expect_color(color_of(camera + sheet(clear(0.5), 2) + sheet(clear(0.8), 1)), {0.4, 0.2, 0.1}, 1e-6);
  // Ambient and mirror image of the sheet are added.
  const std::string own = "shiny 0 0 0 0.1 0.2 0.3 0 0 0 1 0.25 0.5 1\n";
  expect_color(color_of(camera + sheet(own, 2)), {0.1 + 0.75, 0.2 + 0.375, 0.3 + 0.1875}, 1e-6);
}

TEST(Transmission, EndsAtTheLastDepth) {
  std::string scene = look({0, 5, 0}, {0, -1, 0}) + "background 1 1 1\nmax_depth 2\n";
  scene += sheet(clear(1), 3) + sheet(clear(1), 2);
  expect_color(color_of(scene), {1, 1, 1}, 1e-6);
  expect_color(color_of(scene + sheet(clear(1), 1)), {}, 0);
}

// Light on a floor: through nothing, one sheet, two, a glass ball (two surfaces), and something that lets none through.
TEST(TransparentShadows, AreTheProductOfAllThatIsCrossed) {
  const std::string scene = look({3, 1, 0}, {-3, -1, 0}) + "light 0 9 0 1 1 1\nsurface 1 1 1\nbox -50 -1 -50 50 0 50\n";
  const std::string glass_ball = "shiny 0 0 0 0 0 0 0 0 0 1 0 0.5 1.5\nsphere 0.5 0 4 0\n";
  const std::string mirror_ball = "reflective 0 0 0 0 0 0 1\nsphere 0.5 0 4 0\n";
  const RenderSettings settings = with_transparent_shadows();
  const auto both = [&](const std::string& text, double expected, double plain) {
    expect_color(color_of(text, settings), Vec3{1, 1, 1} * expected, 1e-5);
    expect_color(color_of(text), Vec3{1, 1, 1} * plain, 1e-5);
  };
  both(scene, 1, 1);
  both(scene + sheet(clear(0.5), 6), 0.5, 0);
  both(scene + sheet(clear(0.5), 6) + sheet(clear(0.75), 5), 0.375, 0);
  both(scene + glass_ball, 0.25, 0);
  both(scene + glass_ball + sheet(clear(0.5), 6), 0.125, 0);
  both(scene + mirror_ball, 0, 0);
  both(scene + mirror_ball + sheet(clear(0.5), 6), 0, 0);
  // Beyond the light nothing counts.
  both(scene + sheet(clear(0.5), 10) + "surface 1 0 0\nsphere 1 0 12 0\n", 1, 1);
}

// A translucent surface does not stand in its own light from behind: through itself it is lit by k_trans. Its own side
// away from the light has N.L < 0 for a solid; a ball's far inside is lit through the near side.
TEST(TransparentShadows, ThinSheetLitFromBehindStaysDark) {
  // A triangle's normal turns to the viewer: the light behind gives N.L < 0 and so nothing.
  const std::string text = look({0, 2, 0}, {0, -1, 0}) + "light 0 -5 0 1 1 1\ntranslucent 1 1 1 0 0 0 1 0 0 0.5 1 0\n" +
                           "begin\nvertex -50 0 -50\nvertex 0 0 90\nvertex 60 0 -50\nend\n";
  expect_color(color_of(text, with_transparent_shadows()), {}, 1e-6);
}

TEST(TransparentShadows, GroundInsideGlassIsLitThroughIt) {
  // A floor point inside a big glass ball, the light outside: one surface is crossed.
  const std::string text = look({0, 1, 0}, {0, -1, 0}) +
                           "light 0 9 0 1 1 1\nsurface 1 1 1\nbox -1 -1 -1 1 0 1\n"
                           "shiny 0 0 0 0 0 0 0 0 0 1 0 0.5 1.5\nsphere 4 0 0 0\n";
  expect_color(color_of(text, with_transparent_shadows()), {0.5, 0.5, 0.5}, 1e-5);
  expect_color(color_of(text), {}, 0);
}

}  // namespace
}  // namespace penumbra::test
