// Where the ray of a pixel goes: pixel centres, the course's corners, pictures that are not square, turned cameras; and
// what a scene looks like that says nothing.
#include <gtest/gtest.h>

#include <numbers>

#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

// The direction of the ray through column i, row j (which may be broken numbers), as the language page has it.
Vec3 ray_direction(double i, double j, int width, int height, double fov, Course course = Course::off) {
  const double k = std::tan(fov * std::numbers::pi / 360);
  if (course == Course::year_2015) {
    return normalize(
        {(i - (width - 1) / 2.0) * 2 * k / (width - 1), ((height - 1) / 2.0 - j) * 2 * k / (height - 1), -1});
  }
  const int shorter = std::min(width, height);
  return normalize({(i - width / 2.0) * 2 * k / shorter, (height / 2.0 - j) * 2 * k / shorter, -1});
}

void expect_directions(int width, int height, Course course) {
  RenderSettings settings = without_shadows();
  settings.course = course;
  const double offset = course != Course::off ? 0 : 0.5;
  // Looked at with all three signs of colour, since a colour is never negative.
  for (const Vec3 signs : {Vec3{1, 1, 1}, Vec3{-1, -1, -1}}) {
    const Picture3 picture =
        render_text(fmt::format("image_size {} {}\nfov 70\n", width, height) + environment(signs), settings);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        const Vec3 d = ray_direction(x + offset, y + offset, width, height, 70, course);
        expect_color(picture.at(x, y), max(Vec3{d.x * signs.x, d.y * signs.y, d.z * signs.z}, {}), 1e-4);
      }
    }
  }
}

TEST(Camera, PixelCentres) {
  expect_directions(8, 8, Course::off);
  expect_directions(12, 5, Course::off);
  expect_directions(4, 9, Course::off);
}

TEST(Camera, CourseCorners) {
  for (const Course course : {Course::any_year, Course::year_2017, Course::year_2022}) {
    expect_directions(8, 8, course);
    expect_directions(12, 5, course);
    expect_directions(7, 9, course);
  }
}

TEST(Camera, In2015TheOutermostPixelsLieOnTheEdgesOfTheView) {
  expect_directions(8, 8, Course::year_2015);
  expect_directions(12, 5, Course::year_2015);
  expect_directions(7, 9, Course::year_2015);
}

TEST(Camera, FieldOfViewIsSixtyDegreesByDefault) {
  const Picture3 picture = render_text("image_size 6 6\n" + environment({1, 1, -1}), without_shadows());
  const Vec3 d = ray_direction(4.5, 1.5, 6, 6, 60);
  expect_color(picture.at(4, 1), {d.x, d.y, -d.z}, 1e-4);
}

TEST(Camera, EyeAndFrame) {
  // Looks along +x, with z to the right and y up.
  const std::string text = "image_size 6 6\nfov 50\neye 3 2 1\nuvw 0 0 1 0 1 0 -1 0 0\n" + environment({1, 1, 1});
  const Picture3 picture = render_text(text, without_shadows());
  const Vec3 d = ray_direction(4.5, 1.5, 6, 6, 50);
  expect_color(picture.at(4, 1), seen_normal({3, 2, 1}, {-d.z, d.y, d.x}), 1e-4);
}

// With more than one ray a pixel they are spread over the pixel's own square, with the course's switch over the square
// round its corner: the edge of a half plane tells by how much of each pixel it covers. 1024 samples of the default
// pattern and 2^16 independent ones; five standard deviations, an error in 10^6 for other seeds.
TEST(Camera, RaysCoverThePixel) {
  // Light to the right of x = 0.3 pixels from the middle, at distance 10; a pixel is 1 wide there.
  const double k = std::tan(30 * std::numbers::pi / 180);
  const double pixel = 10 * 2 * k / 4;
  const std::string scene = fmt::format(
      "image_size 4 4\nfov 60\nsurface 0 0 0\ndiffuse 0 0 0 1 1 1\nbox {} -99 -10.0001 99 99 -10\n", 0.3 * pixel);
  const Picture3 own = render_text(scene + "rays_per_pixel 1024\n");
  EXPECT_NEAR(own.at(1, 2).x, 0, 1e-6);
  EXPECT_NEAR(own.at(2, 2).x, 0.7, 0.01);
  EXPECT_NEAR(own.at(3, 2).x, 1, 1e-6);
  RenderSettings course;
  course.course = Course::any_year;
  course.pattern = Pattern::random;
  const Picture3 corner = render_text(scene + "rays_per_pixel 65536\n", course);
  const double deviation = 5 * std::sqrt(0.2 * 0.8 / 65536);
  EXPECT_NEAR(corner.at(1, 2).x, 0, 1e-6);
  EXPECT_NEAR(corner.at(2, 2).x, 0.2, deviation);
  EXPECT_NEAR(corner.at(3, 2).x, 1, 1e-6);
}

TEST(Defaults, BackgroundIsBlack) { expect_color(color_of(look({}, {0, 0, -1})), {}, 0); }

TEST(Defaults, SurfaceIsWhiteWithoutAmbient) {
  expect_color(color_of(look({}, {0, 0, -1}) + "light 0 0 0 0.7 0.8 0.9\nsphere 1 0 0 -4\n"), {0.7, 0.8, 0.9}, 1e-5);
  expect_color(color_of(look({}, {0, 0, -1}) + "sphere 1 0 0 -4\n"), {}, 0);
}

TEST(Defaults, LastDepthIsEight) {
  // Between two mirrors that add 1, the ray of depth 8 is the last.
  const std::string mirrors = "reflective 0 0 0 1 1 1 1\nbox -9 -9 -3 9 9 -2\nbox -9 -9 2 9 9 3\n";
  expect_color(color_of(look({}, {0, 0, -1}) + mirrors), {9, 9, 9}, 1e-5);
}

}  // namespace
}  // namespace penumbra::test
