// The thin lens: a small bright ball at distance D is blurred to a disk of radius r = R |D - P| / P at its own
// distance, uniform, and sharp in the focus plane. Radius and uniformity are told by the second moment of its picture,
// brightness by the sum. Independent samples: limits are five standard errors or more, one seed in 10^6; the default
// pattern stays within them.
#include <gtest/gtest.h>

#include <numbers>

#include "base/test_scale.hpp"
#include "rendering/render_text.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

constexpr double focus = 6, lens = 0.3, ball = 0.02;
constexpr int pixels = 64;
constexpr int rays = scaled(1024, 64);

struct Blob {
  double sum = 0, x = 0, y = 0, xx = 0, yy = 0, farthest = 0;
};

// Moments in units of tan(angle).
Blob blob_of(const Picture3& picture, double pixel) {
  Blob b;
  for (int j = 0; j < pixels; j++) {
    for (int i = 0; i < pixels; i++) {
      const double v = picture.at(i, j).x;
      const double x = (i + 0.5 - pixels / 2.0) * pixel, y = (pixels / 2.0 - j - 0.5) * pixel;
      b.sum += v;
      b.x += v * x;
      b.y += v * y;
      b.xx += v * x * x;
      b.yy += v * y * y;
      if (v > 0) b.farthest = std::max(b.farthest, std::hypot(x, y));
    }
  }
  b.x /= b.sum;
  b.y /= b.sum;
  b.xx = b.xx / b.sum - b.x * b.x;
  b.yy = b.yy / b.sum - b.y * b.y;
  return b;
}

void check_blur(double distance, Pattern pattern) {
  const double radius = lens * std::abs(distance - focus) / focus;  // at the ball's distance
  const double reach = (radius + ball) / distance;
  const double half_view = 1.5 * reach;
  const double pixel = 2 * half_view / pixels;
  RenderSettings settings;
  settings.pattern = pattern;
  const std::string text = fmt::format(
      "image_size {0} {0}\nfov {1:.15g}\nrays_per_pixel {2}\nlens {3} {4}\ndiffuse 0 0 0 1 1 1\nsphere {5} 0 0 {6}\n",
      pixels, 2 * std::atan(half_view) * 180 / std::numbers::pi, rays, lens, focus, ball, -distance);
  const Blob blob = blob_of(render_text(text, settings), pixel);
  // A disk of radius a has the second moment a^2 / 4 along each axis; a pixel adds a twelfth of its square.
  const double moment = (radius * radius + ball * ball) / (4 * distance * distance) + pixel * pixel / 12;
  // About this many samples hit the ball.
  const double area = std::numbers::pi * ball * ball / (distance * distance) / (pixel * pixel);
  const double hits = area * rays;
  const double error = 5 / std::sqrt(hits);
  EXPECT_NEAR(blob.xx, moment, moment * (error + 0.01)) << distance;
  EXPECT_NEAR(blob.yy, moment, moment * (error + 0.01)) << distance;
  EXPECT_NEAR(blob.sum, area, area * (error + 0.01)) << distance;
  EXPECT_NEAR(blob.x, 0, std::sqrt(moment) * error);
  EXPECT_NEAR(blob.y, 0, std::sqrt(moment) * error);
  EXPECT_LE(blob.farthest, reach + pixel);
  EXPECT_GE(blob.farthest, 0.85 * reach);
}

TEST(Lens, BlurBehindBeforeAndInTheFocusPlane) {
  for (const double distance : {2.0, 4.0, 5.5, 6.0, 7.0, 12.0, 40.0}) {
    check_blur(distance, Pattern::random);
    check_blur(distance, Pattern::sobol);
  }
}

// What is in focus is a plane, not a sphere round the eye: at 40 degrees off the axis too a ball in the plane is sharp.
TEST(Lens, FocusIsAPlane) {
  const double x = focus * std::tan(40 * std::numbers::pi / 180);
  const auto covered = [&](const std::string& lens_line) {
    const Picture3 picture = render_text(
        fmt::format("image_size 200 200\nfov 100\nrays_per_pixel {}\n{}diffuse 0 0 0 1 1 1\nsphere 0.2 {} 0 {}\n",
                    scaled(64, 16), lens_line, x, -focus));
    int count = 0;
    for (std::size_t i = 0; i < picture.color.size(); i += 3) count += picture.color[i] > 0;
    return count;
  };
  const int sharp = covered("");
  EXPECT_GT(sharp, 15);
  // The ball itself is thick, and seen from all over the lens: a rim of less than a pixel.
  EXPECT_LE(covered("lens 0.5 6\n"), sharp * 1.5 + 4);
}

// A lens of radius 0 is a pinhole.
TEST(Lens, OfNoRadius) {
  const std::string scene = "image_size 20 20\nbackground 0.2 0.3 0.4\nlight 3 4 5 1 1 1\nsphere 1 0.2 0.1 -4\n";
  EXPECT_EQ(render_text(scene).color, render_text("lens 0 3\n" + scene).color);
}

// The lens lies in the camera's own plane.
TEST(Lens, FollowsTheCamera) {
  // Looks along +x; the frame's axes are not the world's.
  const std::string camera = "eye 1 2 3\nuvw 0 0 1 0 1 0 -1 0 0\n";
  const auto width_and_height = [&](const std::string& text) {
    const Blob blob = blob_of(render_text(text), 1);
    return std::pair(blob.xx, blob.yy);
  };
  const std::string common =
      fmt::format("image_size 64 64\nfov 40\nrays_per_pixel {}\nlens 0.5 3\ndiffuse 0 0 0 1 1 1\n", scaled(256, 64));
  const auto [x, y] = width_and_height(common + "sphere 0.2 0 0 -6\n");
  const auto [u, v] = width_and_height(common + camera + "sphere 0.2 7 2 3\n");
  EXPECT_NEAR(u, x, 0.03 * x);
  EXPECT_NEAR(v, y, 0.03 * y);
}

}  // namespace
}  // namespace penumbra::test
