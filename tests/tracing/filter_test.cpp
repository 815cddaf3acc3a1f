// The filters of a pixel: what they weigh, and what they make of an edge.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "rendering/film_values.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

constexpr PixelFilter wide_filters[] = {PixelFilter::triangle, PixelFilter::gaussian};

// The filters as their papers and the manual have them, without their scale.
double filter_at(PixelFilter filter, double x) {
  x = std::abs(x);
  switch (filter) {
    case PixelFilter::box:
      return x < 0.5;
    case PixelFilter::triangle:
      return std::max(0.0, 1 - x);
    case PixelFilter::gaussian:
      return std::max(0.0, std::exp(-2 * x * x) - std::exp(-4.5));
  }
  return 0;
}

// The share of a filter that lies to the left of x.
double filter_left_of(PixelFilter filter, double x) {
  constexpr int parts = 40'000;
  double left = 0, whole = 0;
  for (int i = 0; i < parts; i++) {
    const double at = -2 + 4 * (i + 0.5) / parts;
    whole += filter_at(filter, at);
    if (at < x) left += filter_at(filter, at);
  }
  return left / whole;
}

TEST(FilterSteps, AreTheFilter) {
  for (const PixelFilter filter : wide_filters) {
    const FilterSteps steps = make_filter_steps(filter);
    for (std::uint32_t i = 0; i < FilterSteps::count; i++) {
      EXPECT_LT(steps.ends[i], steps.ends[i + 1]);
      EXPECT_EQ(steps.ends[i], -steps.ends[FilterSteps::count - i]);
      EXPECT_NEAR((i + 1.0) / FilterSteps::count, filter_left_of(filter, steps.ends[i + 1]), 2e-4);
    }
  }
}

// A white half beside a black one, with its edge at an odd place: each column has the share of its filter that is
// white.
TEST(Filter, SpreadsAnEdge) {
  // The eye sees from x = -4.5 to 4.5, a unit a pixel.
  const std::string edge =
      "image_size 9 9\nfov 90\neye 0 0 4.5\nrays_per_pixel 4096\ndiffuse 0 0 0 1 1 1\n"
      "begin\nvertex -100 -100 0\nvertex 0.3 -100 0\nvertex 0.3 100 0\nvertex -100 100 0\nend\n";
  for (const PixelFilter filter : {PixelFilter::box, PixelFilter::triangle, PixelFilter::gaussian}) {
    Scene scene = scene_from(edge);
    scene.settings.filter = filter;
    const Picture3 picture = render_scene(scene);
    for (int x = 0; x < 9; x++) {
      const double center = x - 4;
      EXPECT_NEAR(picture.at(x, 4).x, filter_left_of(filter, 0.3 - center), 2e-3)
          << x << ' ' << static_cast<int>(filter);
    }
  }
}

TEST(Filter, KeepsAnEvenPicture) {
  Scene scene = scene_from("image_size 5 4\nbackground 0.5 0.25 1\nrays_per_pixel 64\n");
  for (const PixelFilter filter : wide_filters) {
    scene.settings.filter = filter;
    const Picture3 picture = render_scene(scene);
    for (int x = 0; x < 5; x++) EXPECT_NEAR(picture.at(x, 2).y, 0.25, 1e-6);
  }
}

TEST(Filter, OfOneRayAndOfTheCourseIsTheBox) {
  Scene scene = scene_from("image_size 5 4\nrays_per_pixel 2\nfilter gaussian\n");
  EXPECT_EQ(frame_from(scene).filter, PixelFilter::gaussian);
  EXPECT_EQ(frame_from(scene, {.course = Course::any_year}).filter, PixelFilter::box);
  scene.settings.antialiasing = false;
  EXPECT_EQ(frame_from(scene).filter, PixelFilter::box);
  scene.settings.antialiasing = true;
  scene.settings.rays_per_pixel = 1;
  EXPECT_EQ(frame_from(scene).filter, PixelFilter::box);
}

// Pixels need nothing of each other.
TEST(Filter, PixelsAreIndependent) {
  Scene scene = scene_from("image_size 9 9\nlight 3 3 3 1 1 1\nrays_per_pixel 5\nfilter gaussian\nsphere 1 0 0 -3\n");
  RenderSettings settings;
  const Picture3 whole = render_scene(scene, settings);
  settings.crop = PixelRect{3, 2, 6, 5};
  const Picture3 part = render_scene(scene, settings);
  for (int y = 2; y < 5; y++) {
    for (int x = 3; x < 6; x++) EXPECT_EQ(part.at(x, y), whole.at(x, y));
  }
}

}  // namespace
}  // namespace penumbra::test
