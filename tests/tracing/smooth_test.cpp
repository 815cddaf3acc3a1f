// Meshes with vertex normals: one ray against the arithmetic, spheres against the shape that they stand for, and both
// rooms of the world against each other.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/test_folder.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

class Smooth : public testing::Test {
 protected:
  // The command that reads a mesh file with this content.
  std::string mesh(const std::string& name, const std::string& content, const std::string& flat = "") const {
    put_content(folder_ / name, content);
    return fmt::format("mesh \"{}\" {}\n", (folder_ / name).string(), flat);
  }

 private:
  const TestFolder folder_;
};

// A triangle round the origin of the xy plane, with the mean of its normals there.
std::string one_triangle(Vec3 normal_a, Vec3 normal_b, Vec3 normal_c, const std::string& face = "f 1//1 2//2 3//3\n") {
  return fmt::format("v -1 -1 0\nv 1 -1 0\nv 0 2 0\nvn {}\nvn {}\nvn {}\n", numbers(normal_a), numbers(normal_b),
                     numbers(normal_c)) +
         face;
}

Vec3 clamped(Vec3 v) { return max(v, Vec3{}); }

// A sphere of radius 1 as n x 2n faces, with its exact normals, scaled: their length says nothing.
std::string sphere(int n, double scale = 1) {
  std::string text;
  for (int i = 0; i <= n; i++) {
    for (int k = 0; k < 2 * n; k++) {
      const double theta = M_PI * i / n, phi = M_PI * k / n;
      const Vec3 p{std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)};
      text += fmt::format("v {}\nvn {}\n", numbers(p), numbers(p * scale));
    }
  }
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 2 * n; k++) {
      const int next = (k + 1) % (2 * n), a = 2 * n * i + 1, b = a + 2 * n;
      text += fmt::format("f {0}//{0} {1}//{1} {2}//{2} {3}//{3}\n", a + k, b + k, b + next, a + next);
    }
  }
  return text;
}

TEST_F(Smooth, MirrorsTurnAboutTheInterpolatedNormal) {
  const Vec3 a{.3, 0, 1}, b{0, .2, 1}, c{.1, .3, 1};
  const Vec3 n = normalize(normalize(a) + normalize(b) + normalize(c));
  for (const bool other_winding : {false, true}) {
    for (const double side : {1., -1.}) {
      const Vec3 direction{0, 0, -side}, turned = n * side;
      const Vec3 mirror = direction - turned * (2 * dot(direction, turned));
      for (const double sign : {1., -1.}) {
        const std::string face = other_winding ? "f 3//3 2//2 1//1\n" : "f 1//1 2//2 3//3\n";
        const std::string text = look({0, 0, 5 * side}, direction) + "reflective 0 0 0 0 0 0 1\n" +
                                 mesh("t.obj", one_triangle(a, b, c, face)) + environment({sign, sign, sign});
        expect_color(color_of(text, without_shadows()), clamped(seen_normal({}, mirror) * sign), 1e-4);
      }
    }
  }
}

TEST_F(Smooth, MirrorsFoldBackWhatPointsIntoTheTriangle) {
  const Vec3 n = normalize({1, 0, .3}), direction{0, 0, -1};
  const Vec3 mirror = direction - n * (2 * dot(direction, n));
  ASSERT_LT(mirror.z, 0);
  const std::string text = look({0, 0, 5}, direction) + "reflective 0 0 0 0 0 0 1\n" +
                           mesh("t.obj", one_triangle(n, n, n)) + environment({1, 1, 1});
  expect_color(color_of(text, without_shadows()), seen_normal({}, {mirror.x, 0, -mirror.z}), 1e-4);
}

TEST_F(Smooth, GlassBendsAboutTheInterpolatedNormal) {
  const Vec3 n = normalize({.3, .1, 1}), direction{0, 0, -1};
  const double ratio = 1 / 1.5, cosine = n.z;
  const Vec3 refracted =
      direction * ratio + n * (ratio * cosine - std::sqrt(1 - ratio * ratio * (1 - cosine * cosine)));
  const std::string text = look({0, 0, 5}, direction) + "shiny 0 0 0 0 0 0 0 0 0 1 0 1 1.5\n" +
                           mesh("t.obj", one_triangle(n, n, n)) + environment({-1, -1, -1});
  expect_color(color_of(text, without_shadows()), clamped(seen_normal({}, refracted) * -1), 1e-4);
}

TEST_F(Smooth, NormalsFollowInstancesAndMotion) {
  const std::string scene = look({0, 0, 5}, {0, 0, -1}) + "light 1e7 2e7 3e7 1 1 1\n";
  const Vec3 n = normalize({.4, .2, 1}), to_light = normalize({1, 2, 3});
  const auto expect_lit = [&](const std::string& objects, Vec3 normal) {
    const double cosine = dot(normalize(normal), to_light);
    expect_color(color_of(scene + objects), {cosine, cosine, cosine}, 1e-5);
  };
  const std::string t = mesh("t.obj", one_triangle(n, n, n));
  expect_lit(t, n);
  expect_lit("scale 2 1 .5\n" + t, {n.x / 2, n.y, n.z * 2});
  expect_lit(t + "named_object t\nscale 2 1 .5\ninstance t\n", {n.x / 2, n.y, n.z * 2});
  expect_lit("push\nscale 2 1 1\n" + t + "pop\nnamed_object t\nrotatez 90\nscale -3 1 1\ninstance t\n",
             {-n.y, -n.x / 6, n.z});
  expect_lit(t + "moving_object 0 0.1 0.2\n", n);
  expect_lit(t + "named_object t\ninstance t\nmoving_object 0 0.1 0.2\n", n);
}

constexpr int side = 150;
constexpr double degrees = 34;

// How a picture differs from that of the sphere where that is not seen at too flat an angle: the mean and the largest
// difference.
struct Difference {
  double mean = 0, largest = 0;
};
Difference difference(const Picture3& picture, const Picture3& exact) {
  Difference d;
  int count = 0;
  const double scale = 2 * std::tan(degrees / 2 * M_PI / 180) / side;
  for (int y = 0; y < side; y++) {
    for (int x = 0; x < side; x++) {
      const Vec3 direction = normalize({(x + .5 - side / 2.) * scale, (side / 2. - y - .5) * scale, -1});
      if (length(cross(direction, {0, 0, -4})) > 0.8) continue;
      const double here = std::abs(picture.at(x, y).x - exact.at(x, y).x);
      d.mean += here;
      d.largest = std::max(d.largest, here);
      count++;
    }
  }
  d.mean /= count;
  return d;
}

// Lit from all sides, so that the edge of the light runs over many triangles.
TEST_F(Smooth, ASphereOfTrianglesIsLitLikeASphere) {
  for (const std::string light : {"5 2 0", "-3 4 -5", "0.3 5 1", "2 -2 4"}) {
    const std::string scene = fmt::format("image_size {0} {0}\nfov {1}\nlight ", side, degrees) + light +
                              " 1 0 0\nsurface 1 1 0\ntranslate 0 0 -4\nrotate 20 1 1 0\n";
    const Picture3 exact = render_text(scene + "sphere 1 0 0 0\n");
    for (const int n : {12, 30, 60}) {
      const Difference smooth = difference(render_text(scene + mesh("s.obj", sphere(n, 3))), exact);
      const Difference flat = difference(render_text(scene + mesh("s.obj", sphere(n, 3), "flat")), exact);
      EXPECT_LT(smooth.mean, 0.8 / n / n) << n << ' ' << light;
      EXPECT_LT(smooth.largest, 4.0 / n / n) << n << ' ' << light;
      EXPECT_GT(flat.mean, 5 * smooth.mean) << n << ' ' << light;
      EXPECT_GT(flat.largest, 2 * smooth.largest) << n << ' ' << light;
    }
  }
}

TEST_F(Smooth, WhatIsFlatIsRenderedAsWithoutNormals) {
  std::string without;
  const std::string with = sphere(12);
  for (std::size_t at = 0; at < with.size();) {
    const std::size_t end = with.find('\n', at) + 1;
    std::string line = with.substr(at, end - at);
    at = end;
    if (line[1] == 'n') continue;
    for (std::size_t slash; (slash = line.find('/')) != line.npos;)
      line.erase(slash, line.find_first_of(" \n", slash) - slash);
    without += line;
  }
  const std::string scene =
      "image_size 64 64\nfov 40\nrays_per_pixel 4\ndisk_light 5 2 0 1 1 0 0 1 1 1\n"
      "shiny .4 .4 .4 .1 .1 .1 1 1 1 20 .3 .2 1.4\ntranslate 0 0 -4\n";
  const ZeroedVector<float> bare = render_text(scene + mesh("b.obj", without)).color;
  EXPECT_EQ(render_text(scene + mesh("a.obj", with, "flat")).color, bare);
  EXPECT_NE(render_text(scene + mesh("a.obj", with)).color, bare);
  // Beside a mesh with normals, behind the eye.
  EXPECT_EQ(render_text(scene + mesh("b.obj", without) + "translate 0 0 90\n" + mesh("a.obj", with)).color,
            render_text(scene + mesh("b.obj", without) + "translate 0 0 90\n" + mesh("a.obj", with, "flat")).color);
}

Picture3 render_in(const Scene& scene, std::uint32_t embree_threshold) {
  WorldOptions options;
  options.embree_threshold = embree_threshold;
  const Frame frame = make_frame(scene, build_world(scene, options));
  Plan plan;
  plan.crop = {0, 0, scene.settings.width, scene.settings.height};
  Film film(plan.crop, plan.layers);
  RenderState state;
  const auto rays = static_cast<std::uint32_t>(scene.settings.rays_per_pixel);
  const RayCounts counts = render_samples(film, frame, *usable_kernels().back(), plan, {0, rays}, state);
  return Picture3(std::move(film), counts);
}

// Half of the faces have no normals. Light that grazes a smooth face from inside is stopped by that face in Embree,
// which does not know where a ray starts, and by its smooth normal in our tree.
TEST_F(Smooth, BothRoomsAgree) {
  std::string half = sphere(16);
  for (std::size_t at = half.find("f "); at != half.npos; at = half.find("f ", at + 40)) {
    half.erase(half.find('/', at), half.find(' ', at + 2) - half.find('/', at));
  }
  const Scene scene = scene_from(
      "image_size 80 80\nfov 50\nrays_per_pixel 4\nbackground .2 .3 .4\ndisk_light 5 2 0 1 1 0 0 1 1 1\nlight -3 -1 4 "
      ".3 .3 .3\n"
      "translate 0 0 -4\nshiny .4 .4 .4 .1 .1 .1 1 1 1 20 .3 .2 1.4\npush\ntranslate -1 0 0\n" +
      mesh("h.obj", half) + "pop\n" + mesh("s.obj", sphere(12)) +
      "named_object s\ntranslate 1 0 .5\nscale 1 1.3 .8\ninstance s\n" + "rotatez 30\ntranslate 0 1.5 -1\n" +
      mesh("s.obj", sphere(12)) + "moving_object .2 0 0\n");
  const Picture3 ours = render_in(scene, 1u << 30), embree = render_in(scene, 1);
  std::size_t differ = 0;
  for (std::size_t i = 0; i < ours.color.size(); i++) differ += std::abs(ours.color[i] - embree.color[i]) > 2e-3f;
  EXPECT_LT(differ, ours.color.size() / 200);
}

}  // namespace
}  // namespace penumbra::test
