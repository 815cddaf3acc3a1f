// Refraction of a single ray: Snell's law through a ball and through a closed mesh, total reflection in both, and the
// factors that go with them. The way of the ray is computed anew here, in double precision.
#include <gtest/gtest.h>

#include <numbers>

#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

Vec3 snell(Vec3 d, Vec3 facing, double ratio) {
  const double cosine = -dot(d, facing);
  const double k = 1 - ratio * ratio * (1 - cosine * cosine);
  return d * ratio + facing * (ratio * cosine - std::sqrt(k));
}

// Through the unit ball at `center`, in and out.
void pass_ball(Vec3 center, double index, Vec3& origin, Vec3& d) {
  Vec3 from = origin - center;
  const double b = dot(from, d);
  from = from + d * (-b - std::sqrt(b * b - dot(from, from) + 1));
  d = snell(d, from, 1 / index);
  from = from + d * (-2 * dot(from, d));
  d = snell(d, -from, index);
  origin = center + from;
}

std::string glass(double index) { return fmt::format("shiny 0 0 0 0 0 0 0 0 0 1 0 1 {}\n", index); }

TEST(Refraction, SnellThroughABall) {
  const Vec3 center{0, 0, -5};
  for (const double index : {1.0, 1.1, 1.33, 1.5, 2.4}) {
    for (const double x : {0.0, 0.2, 0.5, 0.8, 0.95}) {
      Vec3 origin{x, 0.1, 0}, d{0, 0, -1};
      const std::string text = look(origin, d) + glass(index) + fmt::format("sphere 1 {}\n", numbers(center));
      pass_ball(center, index, origin, d);
      const Vec3 normal = seen_normal(origin, d);
      const Vec3 signs{normal.x < 0 ? -1.0 : 1.0, normal.y < 0 ? -1.0 : 1.0, normal.z < 0 ? -1.0 : 1.0};
      expect_color(color_of(text + environment(signs), without_shadows()), abs(normal), 2e-4);
    }
  }
}

// A prism with a right angle, as a closed mesh: along x it is the triangle (0,0) (2,0) (0,2) in y and z.
std::string prism(const std::string& surface, bool outward = true) {
  const Vec3 p[6] = {{-1, 0, 0}, {-1, 2, 0}, {-1, 0, 2}, {1, 0, 0}, {1, 2, 0}, {1, 0, 2}};
  constexpr int faces[8][3] = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {0, 3, 5}, {0, 5, 2}, {1, 2, 5}, {1, 5, 4}};
  std::string text = surface;
  for (const auto& face : faces) {
    text += "begin\n";
    for (int k = 0; k < 3; k++) text += "vertex " + numbers(p[face[outward ? k : 2 - k]]) + "\n";
    text += "end\n";
  }
  return text;
}

// Down through the face z = ... is not needed: the ray enters by y = 0 upward, meets the slanted face at 45 degrees
// from inside and is turned to -z, where it leaves by the face z = 0.
TEST(Refraction, TotalReflectionInAPrism) {
  const double reflection = 0.25, transmission = 0.7;
  const std::string surface = fmt::format("shiny 0 0 0 0 0 0 0 0 0 1 {} {} 1.5\n", reflection, transmission);
  const std::string text =
      look({0.1, -3, 0.9}, {0, 1, 0}) + "max_depth 3\n" + prism(surface) + "diffuse 0 0 0 1 1 1\nbox -1 0 -4 1 2 -3\n";
  const double expected = transmission * (reflection + transmission) * transmission;
  expect_color(color_of(text), Vec3{1, 1, 1} * expected, 1e-5);
  // With an index below the critical one for 45 degrees the card is not seen.
  const std::string thin = fmt::format("shiny 0 0 0 0 0 0 0 0 0 1 0 {} 1.3\n", transmission);
  expect_color(color_of(look({0.1, -3, 0.9}, {0, 1, 0}) + "max_depth 3\n" + prism(thin) +
                        "diffuse 0 0 0 1 1 1\nbox -1 0 -4 1 2 -3\n"),
               {}, 0);
}

TEST(Refraction, SnellThroughAPrism) {
  // Below the critical angle: out through the slanted face, bent away from its normal.
  const double index = 1.2;
  const Vec3 eye{0.1, -3, 0.9}, up{0, 1, 0};
  const Vec3 slanted = normalize({0, 1, 1});
  const Vec3 d = snell(up, -slanted, index);
  const Vec3 normal = seen_normal({0.1, 1.1, 0.9}, d);
  const std::string text = look(eye, up) + prism(glass(index)) + environment({1, 1, normal.z < 0 ? -1.0 : 1.0});
  expect_color(color_of(text, without_shadows()), abs(normal), 2e-4);
}

// Inside and outside are told by the outward side (B-A)x(C-A): turned inside out, the prism is air in glass.
TEST(Refraction, OutwardSideDecides) {
  const double index = 1.2;
  const Vec3 eye{0.1, -3, 0.9}, up{0, 1, 0};
  const Vec3 slanted = normalize({0, 1, 1});
  const Vec3 d = snell(up, -slanted, 1 / index);
  const Vec3 normal = seen_normal({0.1, 1.1, 0.9}, d);
  const std::string text = look(eye, up) + prism(glass(index), false) + environment({1, 1, normal.z < 0 ? -1.0 : 1.0});
  expect_color(color_of(text, without_shadows()), abs(normal), 2e-4);
}

// From inside a ball, beyond the critical angle, light never gets out: every bounce adds ambient and k_refl + k_trans.
TEST(Refraction, TotalReflectionInABall) {
  const double factor = 0.3 + 0.4;
  for (const int depth : {0, 1, 3, 6}) {
    const std::string text = look({0, 0.9, 0}, {0, 0, -1}) + fmt::format("max_depth {}\n", depth) +
                             "background 9 9 9\nshiny 0 0 0 0.25 0.25 0.25 0 0 0 1 0.3 0.4 1.5\nsphere 1 0 0 0\n";
    double expected = 0;
    for (int bounce = 0; bounce <= depth; bounce++) expected += 0.25 * std::pow(factor, bounce);
    expect_color(color_of(text), Vec3{1, 1, 1} * expected, 1e-5);
  }
}

// Light that is totally reflected is spread by the gloss radius, not the blur radius: without gloss it is not spread.
TEST(Refraction, TotalReflectionIsAsFrostedFromInside) {
  const std::string scene = look({0, 0.9, 0}, {0, 0, -1}) +
                            "rays_per_pixel 64\nmax_depth 1\nbackground 9 9 9\n"
                            "translucent 0 0 0 0 0 0 1 0 {} 1 1.5 {}\nsphere 1 0 0 0\ndiffuse 0 0 0 1 1 1\n";
  // The mirror direction of the only bounce, and a small ball in its way.
  const Vec3 hit{0, 0.9, -std::sqrt(1 - 0.81)};
  const Vec3 mirrored = Vec3{0, 0, -1} - hit * (2 * dot({0, 0, -1}, hit));
  const std::string target = fmt::format("sphere 0.01 {}\n", numbers(hit + mirrored * 0.5));
  expect_color(color_of(fmt::format(fmt::runtime(scene), 0, 0) + target), {1, 1, 1}, 1e-6);
  EXPECT_LT(color_of(fmt::format(fmt::runtime(scene), 0.5, 0) + target).x, 0.5);
  EXPECT_LT(color_of(fmt::format(fmt::runtime(scene), 0, 0.5) + target).x, 0.5);
}

// Where all that comes in is white and nothing is lost, a frosted ball is white.
TEST(Refraction, AFrostedBallInAWhiteFurnaceIsWhite) {
  for (const double blur : {0.5, 1.0}) {
    const Picture3 picture = render_text(
        fmt::format("image_size 24 24\nfov 60\neye 0 0 3\nrays_per_pixel 16\nmax_depth 100\nbackground 1 1 1\n"
                    "translucent 0 0 0 0 0 0 1 0 0 1 1.5 {}\nsphere 1 0 0 0\n",
                    blur));
    EXPECT_GT(picture.mean().x, 0.9999) << blur;  // the longest ways end at max_depth
  }
}

}  // namespace
}  // namespace penumbra::test
