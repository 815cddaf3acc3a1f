// The soft shadow of a half plane in the light of a disk: what is left of the disk behind a straight edge is a circular
// segment. 2^14 independent samples a point and 25 points; limits are 5.5 standard deviations, so that a correct
// program fails for one seed in a million. The default pattern has to stay within the same limits, and does easily.
#include <gtest/gtest.h>

#include <numbers>

#include "base/test_scale.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

constexpr double light_height = 10, light_radius = 2, edge_height = 4;
constexpr int rays = scaled(16384, 1024);

// The share of the disk that the floor point (x, 0, 0) sees past the edge at x = 0: the part beyond `cut` radii.
double visible_share(double x) {
  const double cut = x * (1 - light_height / edge_height) / light_radius;
  const double c = std::clamp(cut, -1.0, 1.0);
  return (std::acos(c) - c * std::sqrt(1 - c * c)) / std::numbers::pi;
}

// The mean of N.L over that part, times its share, by a fine midpoint rule.
double expected_light(double x) {
  const double cut = x * (1 - light_height / edge_height);
  constexpr int steps = 400;
  double sum = 0;
  for (int i = 0; i < steps; i++) {
    const double r = light_radius * std::sqrt((i + 0.5) / steps);
    for (int k = 0; k < steps; k++) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / steps;
      const double px = r * std::cos(angle), pz = r * std::sin(angle);
      if (px > cut) sum += light_height / std::sqrt((px - x) * (px - x) + pz * pz + light_height * light_height);
    }
  }
  return sum / (steps * steps);
}

void check_profile(const std::string& lights, Pattern pattern) {
  RenderSettings settings;
  settings.pattern = pattern;
  for (int i = -12; i <= 12; i++) {
    const double x = i * 0.12;
    const std::string text = look({x, 2, 0}, {0, -1, 0}) + fmt::format("rays_per_pixel {}\n", rays) + lights +
                             "surface 1 1 1\nbox -99 -1 -99 99 0 99\nbox -99 4 -99 0 4.001 99\n";
    const double share = visible_share(x);
    const double expected = expected_light(x);
    EXPECT_NEAR(expected, share, 0.06);  // the cosine is near one, so that this is the segment's profile
    // The edge is 0.001 thick, which moves its shadow by less than 0.001 of the disk.
    const double deviation = std::sqrt(share * (1 - share) / rays) + 2e-4;
    EXPECT_NEAR(color_of(text, settings).x, expected, 5.5 * deviation + 1e-3) << "x = " << x;
  }
}

const std::string disk = "disk_light 0 10 0 2 0 -3 0 1 1 1\n";

TEST(Penumbra, DiskLightOverAnEdge) {
  check_profile(disk, Pattern::random);
  check_profile(disk, Pattern::sobol);
}

// All lights but the first draw on other dimensions of the sample.
TEST(Penumbra, SecondLight) {
  check_profile("disk_light 0 9 0 1 0 1 0 0 0 0\n" + disk, Pattern::random);
  check_profile("disk_light 0 9 0 1 0 1 0 0 0 0\n" + disk, Pattern::sobol);
}

// In a mirror the shadow has the same profile: lights of deeper hits are sampled too.
TEST(Penumbra, SeenInAMirror) {
  RenderSettings settings;
  settings.pattern = Pattern::sobol;
  for (const double x : {-0.9, -0.4, 0.0, 0.5}) {
    const std::string text =
        look({x, 2, 0}, {0, 1, 0}) + fmt::format("rays_per_pixel {}\n", rays) + disk +
        "surface 1 1 1\nbox -99 -1 -99 99 0 99\nbox -99 4 -99 0 4.001 99\n" +
        fmt::format("reflective 0 0 0 0 0 0 1\nbox {} 2.5 -0.00001 {} 2.6 0.00001\n", x - 1e-5, x + 1e-5);
    const double share = visible_share(x);
    EXPECT_NEAR(color_of(text, settings).x, expected_light(x), 5.5 * std::sqrt(share * (1 - share) / rays) + 1e-3);
  }
}

// The points are uniform over the disk's area, not bunched at its centre: seen past an edge that cuts off a tenth of
// the radius. (With r = u the share would be far off.)
TEST(Penumbra, SidesOfATiltedDisk) {
  RenderSettings settings;
  settings.pattern = Pattern::random;
  // Tilted by 60 degrees about z: its extent along x is halved, which halves the penumbra's width.
  const std::string tilted = "disk_light 0 10 0 2 0.8660254037844386 0.5 0 1 1 1\n";
  for (const double x : {-0.5, -0.3, 0.0, 0.2, 0.6}) {
    const std::string text = look({x, 2, 0}, {0, -1, 0}) + fmt::format("rays_per_pixel {}\n", rays) + tilted +
                             "surface 1 1 1\nbox -99 -1 -99 99 0 99\nbox -99 4 -99 0 4.001 99\n";
    constexpr int steps = 400;
    double sum = 0, share = 0;
    for (int i = 0; i < steps; i++) {
      const double r = light_radius * std::sqrt((i + 0.5) / steps);
      for (int k = 0; k < steps; k++) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / steps;
        const Vec3 p = Vec3{0.5, -0.8660254037844386, 0} * (r * std::cos(angle)) + Vec3{0, 10, r * std::sin(angle)};
        const double at_edge = x + (p.x - x) * edge_height / p.y;
        if (at_edge < 0) continue;
        share += 1.0 / (steps * steps);
        sum += p.y / length(p - Vec3{x, 0, 0}) / (steps * steps);
      }
    }
    EXPECT_NEAR(color_of(text, settings).x, sum, 5.5 * std::sqrt(share * (1 - share) / rays) + 2e-3) << "x = " << x;
  }
}

}  // namespace
}  // namespace penumbra::test
