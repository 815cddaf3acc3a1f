// The parallelogram that shines: which points of it shadow rays go to, and the shadows that it casts. Statistics fail
// for one seed in a million.
#include <gtest/gtest.h>

#include <random>

#include "base/test_scale.hpp"
#include "rendering/ray_tree.hpp"
#include "sampling/statistics.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

struct Quad {
  Vec3 center, u, v;

  Vec3 at(double s, double t) const { return center + u * s + v * t; }
  std::string line(std::string_view color = "1 1 1") const {
    return fmt::format("quad_light {} {} {} {}\n", numbers(center), numbers(u), numbers(v), color);
  }
};

// A point of a light in the quad's own coordinates; `off` is how far it is from the quad's plane.
struct Coordinates {
  double s, t, off;
};

Coordinates coordinates(const Quad& quad, Vec3 point) {
  const Vec3 p = point - quad.center, n = cross(quad.u, quad.v);
  return {dot(cross(p, quad.v), n) / dot(n, n), dot(cross(quad.u, p), n) / dot(n, n), dot(p, n) / length(n)};
}

// One pixel that looks at a wall below the lights, straight down.
std::string wall(const std::string& lights, int rays) {
  return look({0, 2, 0}, {0, -1, 0}) + fmt::format("rays_per_pixel {}\n", rays) + lights + "box -99 -1 -99 99 0 99\n";
}

// Where the samples' shadow rays to a light go.
std::vector<Coordinates> points_on(const Quad& quad, const Frame& frame, std::uint32_t light) {
  std::vector<Coordinates> points;
  const auto count = static_cast<std::uint32_t>(frame.settings.rays_per_pixel);
  for (std::uint32_t sample = 0; sample < count; sample++) {
    for (const RecordedRay& ray : trace_sample(frame, *usable_kernels().back(), 0, 0, sample, count).rays) {
      if (ray.kind != RayKind::shadow || ray.light != light) continue;
      const Vec3 origin{ray.origin[0], ray.origin[1], ray.origin[2]};
      const Vec3 direction{ray.direction[0], ray.direction[1], ray.direction[2]};
      points.push_back(coordinates(quad, origin + direction * double{ray.light_distance}));
    }
  }
  return points;
}

Frame frame_of(const std::string& text, Pattern pattern) {
  RenderSettings settings;
  settings.pattern = pattern;
  return frame_from(scene_from(text, settings), settings);
}

// Above the wall, at any angle to it, with sides of any angle and length.
Quad random_quad(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-3, 3), edge(-1.5, 1.5);
  const auto vec = [&](auto& number) {
    const double x = number(random), y = number(random);
    return Vec3{x, y, number(random)};
  };
  while (true) {
    const Quad quad{vec(place) + Vec3{0, 7, 0}, vec(edge), vec(edge)};
    if (length(cross(quad.u, quad.v)) > 0.1 * length(quad.u) * length(quad.v)) return quad;
  }
}

TEST(QuadLight, PointsAreUniformOverItsArea) {
  constexpr int quads = 12, cells = 12, samples = scaled(20000, 3000);
  std::mt19937 random(7);
  for (int i = 0; i < quads; i++) {
    const Quad quad = random_quad(random);
    SCOPED_TRACE(quad.line());
    const auto points = points_on(quad, frame_of(wall(quad.line(), samples), Pattern::random), 0);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(samples));
    std::vector<int> counts(cells * cells);
    const auto cell = [](double x) { return std::clamp(static_cast<int>((x + 1) / 2 * cells), 0, cells - 1); };
    for (const Coordinates& p : points) {
      ASSERT_LE(std::max(std::abs(p.s), std::abs(p.t)), 1 + 1e-4);
      ASSERT_NEAR(p.off, 0, 1e-5);
      counts[static_cast<std::size_t>(cell(p.s) * cells + cell(p.t))]++;
    }
    EXPECT_LT(chi_square_deviation(counts), normal_limit(quads));
  }
}

// The first light with an area has the dimensions that are joint with pixel, lens and time, whichever kind it is.
TEST(QuadLight, SharesTheDimensionsOfTheFirstLightWithAnArea) {
  const Quad quad{{1, 6, 2}, {0.8, 0.1, 0.3}, {-0.2, 0.4, 1.1}};
  const std::string points = "light 3 4 5 1 1 1\nspotlight 0 5 0 0 -1 0 10 30 1 1 1\n",
                    disk = "disk_light -3 8 0 1 0 1 0 1 1 1\n";
  constexpr std::uint32_t samples = 64;
  std::vector<float> u(samples), v(samples);
  const auto farthest_from_joint = [&](const std::string& lights, std::uint32_t light) {
    const Frame frame = frame_of(wall(lights, samples), Pattern::sobol);
    usable_kernels().back()->sample_points(frame, 0, 0, first_light_radius, u, v);
    const auto found = points_on(quad, frame, light);
    EXPECT_EQ(found.size(), samples);
    double farthest = 0;
    for (std::size_t i = 0; i < found.size(); i++) {
      farthest = std::max({farthest, std::abs(found[i].s - (2 * u[i] - 1)), std::abs(found[i].t - (2 * v[i] - 1))});
    }
    return farthest;
  };
  EXPECT_LT(farthest_from_joint(quad.line(), 0), 1e-4);
  EXPECT_LT(farthest_from_joint(points + quad.line() + disk, 2), 1e-4);
  EXPECT_GT(farthest_from_joint(disk + quad.line(), 1), 0.5) << "those are the disk's";
  EXPECT_GT(farthest_from_joint(quad.line("0 0 0") + quad.line(), 1), 0.5);
}

// A fixed set of points on the light is as many point lights, each of that share.
TEST(QuadLight, RegularShadowRaysAreAGridOfPointLights) {
  const Quad quad{{1, 6, 2}, {1.5, 0.1, 0.3}, {-0.2, 0.6, 1.1}};
  const std::string scene =
      "image_size 36 24\neye 0 3 8\nsurface 0.9 0.8 0.7\nbox -99 -1 -99 99 0 99\nsphere 1 0 1.5 0\n";
  RenderSettings settings;
  settings.regular_lights = true;
  const Picture3 area = render_text("shadow_rays 16\n" + quad.line() + scene, settings);
  std::string grid;
  for (const double s : {-0.75, -0.25, 0.25, 0.75}) {
    for (const double t : {-0.75, -0.25, 0.25, 0.75}) {
      grid += fmt::format("light {} 0.0625 0.0625 0.0625\n", numbers(quad.at(s, t)));
    }
  }
  const Picture3 points = render_text(grid + scene, settings);
  ASSERT_EQ(area.color.size(), points.color.size());
  int different = 0;
  for (std::size_t i = 0; i < area.color.size(); i++) different += std::abs(area.color[i] - points.color[i]) > 1e-5f;
  EXPECT_EQ(different, 0);
  EXPECT_EQ(area.rays[RayKind::shadow], points.rays[RayKind::shadow]);
}

// The soft shadow of a half plane that ends at x = 0, four above the floor, at the floor point (x, 0, 0).
constexpr double edge_height = 4;
const std::string edge = "surface 1 1 1\nbox -99 -1 -99 99 0 99\nbox -99 4 -99 0 4.001 99\n";

struct Lit {
  double light = 0, share = 0;
};

// The mean over steps x steps points of the quad: of N.L where the point is seen, and of how many are seen.
Lit lit_by(const Quad& quad, double x, int steps) {
  Lit lit;
  for (int i = 0; i < steps; i++) {
    for (int k = 0; k < steps; k++) {
      const Vec3 p = quad.at((2 * i + 1.0) / steps - 1, (2 * k + 1.0) / steps - 1);
      if (x + (p.x - x) * edge_height / p.y < 0) continue;
      lit.share += 1.0 / (steps * steps);
      lit.light += p.y / length(p - Vec3{x, 0, 0}) / (steps * steps);
    }
  }
  return lit;
}

TEST(QuadLight, PenumbraOfAnEdgeIsTheMeanOverManyPoints) {
  constexpr int rays = scaled(16384, 1024);
  const Quad level{{0, 10, 0}, {2, 0, 0}, {0, 0, 1}}, skew{{0.5, 9, 1}, {1.2, -0.5, 0.6}, {0.7, 0.8, -1.1}};
  const std::string black_disk = "disk_light 0 9 0 1 0 1 0 0 0 0\n";
  for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
    RenderSettings settings;
    settings.pattern = pattern;
    for (const Quad& quad : {level, skew}) {
      for (const std::string& before : {std::string(), black_disk}) {
        for (const double x : {-1.1, -0.6, -0.2, 0.0, 0.3, 0.7, 1.2}) {
          const Lit lit = lit_by(quad, x, 400);
          const std::string text =
              look({x, 2, 0}, {0, -1, 0}) + fmt::format("rays_per_pixel {}\n", rays) + before + quad.line() + edge;
          const double deviation = std::sqrt(lit.share * (1 - lit.share) / rays) + 2e-4;
          EXPECT_NEAR(color_of(text, settings).x, lit.light, 5.5 * deviation + 1e-3) << quad.line() << "x = " << x;
        }
      }
    }
  }
}

// Half of a level quad is seen right below the edge; the profile beside it is a straight line.
TEST(QuadLight, PenumbraOfALevelQuadIsARamp) {
  const Quad quad{{0, 10, 0}, {2, 0, 0}, {0, 0, 1}};
  for (const double x : {-1.0, -0.5, 0.0, 0.4, 1.0}) {
    const double share = std::clamp((1 + x * (10 / edge_height - 1) / 2) / 2, 0.0, 1.0);
    EXPECT_NEAR(lit_by(quad, x, 400).share, share, 2e-3);
  }
}

// Two renders: the light, and a picture with as many point lights as make no difference.
TEST(QuadLight, LooksLikeAGridOfPointLights) {
  constexpr int steps = 24;
  const Quad quad{{0.5, 9, 1}, {1.2, -0.5, 0.6}, {0.7, 0.8, -1.1}};
  std::string grid;
  for (int i = 0; i < steps; i++) {
    for (int k = 0; k < steps; k++) {
      grid += fmt::format("light {} {} 0 0\n", numbers(quad.at((2 * i + 1.0) / steps - 1, (2 * k + 1.0) / steps - 1)),
                          1.0 / (steps * steps));
    }
  }
  for (const double x : {-0.6, 0.0, 0.3, 0.7}) {
    const std::string view = look({x, 2, 0}, {0, -1, 0});
    EXPECT_NEAR(color_of(view + "rays_per_pixel 4096\n" + quad.line() + edge).x, color_of(view + grid + edge).x, 0.01);
  }
}

TEST(QuadLight, ShinesToBothSidesWithoutCosineOrFalloff) {
  // So small that it is a point, across the way to the floor and along it.
  for (const std::string edges : {"1e-4 0 0 0 0 1e-4", "0 0 1e-4 1e-4 0 0", "1e-4 0 0 0 1e-4 0"}) {
    for (const double height : {4.0, 400.0}) {
      const std::string text = look({0, 3, 0}, {0, -1, 0}) +
                               fmt::format("quad_light 0 {} 0 {} 0.5 1 2\n", height, edges) +
                               "surface 1 1 1\nbox -20 -1 -20 20 0 20\n";
      expect_color(color_of(text), {0.5, 1, 2}, 1e-4);
    }
  }
}

TEST(QuadLight, IsNeitherSeenNorMoved) {
  const std::string light = "quad_light 0 2 0 1 0 0 0 0 1 1 1 1\n", floor = "surface 1 1 1\nbox -20 -1 -20 20 0 20\n";
  // The eye looks through it at the floor.
  const std::string view = look({0, 3, 0}, {0, -1, 0}) + "rays_per_pixel 64\n";
  const Vec3 seen = color_of(view + light + floor);
  EXPECT_GT(seen.x, 0.8);
  expect_color(color_of(view + "push\ntranslate 5 5 5\nrotate 50 1 2 3\n" + light + "pop\n" + floor, {}), seen, 0);
}

}  // namespace
}  // namespace penumbra::test
