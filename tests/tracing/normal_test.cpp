// Normals and distances of an ellipsoid, however it came about: a matrix round a ball, an instance, an instance of a
// group of instances. Against the closed form: the gradient of its quadratic form, which is the inverse transpose.
#include <gtest/gtest.h>

#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

constexpr int pixels = 48;

struct Exact {
  double depth;
  Vec3 normal;
};

// The unit ball under m, seen from the origin along (x, y, -1).
bool cross_ellipsoid(const Affine& m, Vec3 d, Exact& exact) {
  const Affine inv = inverse(m);
  const Vec3 o = transform_point(inv, {}), v = transform_vector(inv, d);
  const double a = dot(v, v), b = dot(o, v), c = dot(o, o) - 1;
  if (b * b - a * c <= 1e-3) return false;
  const double t = (-b - std::sqrt(b * b - a * c)) / a;
  const Vec3 p = o + v * t;
  exact = {t, normalize({dot(inv.column[0], p), dot(inv.column[1], p), dot(inv.column[2], p)})};
  return true;
}

TEST(Normals, OfEllipsoidsUnderEveryKindOfMatrix) {
  const Affine m = translation({0.3, -0.2, -6}) * rotation(35, {1, 2, 3}) * scaling({0.5, 2, 1.2});
  const std::string matrix = "translate 0.3 -0.2 -6\nrotate 35 1 2 3\nscale 0.5 2 1.2\n";
  const std::string cases[] = {
      matrix + "sphere 1 0 0 0\n", "sphere 1 0 0 0\nnamed_object it\n" + matrix + "instance it\n",
      "begin_list\nsphere 1 0 0 0\nend_list\nnamed_object it\n" + matrix + "instance it\n",
      "push\nrotate 35 1 2 3\nscale 0.5 2 1.2\nbegin_list\nsphere 1 0 0 0\nsphere 0.01 0 0 0\nend_list\nnamed_object "
      "it\npop\n"
      "translate 0.3 -0.2 -6\ninstance it\n",
      "push\nscale 0.5 2 1.2\nbegin_list\nsphere 1 0 0 0\nsphere 0.01 0 0 0\nend_list\nnamed_object inner\npop\npush\n"
      "rotate 35 1 2 3\nbegin_list\ninstance inner\nsphere 0.01 0 0 0\nend_list\nnamed_object outer\npop\n"
      "translate 0.3 -0.2 -6\ninstance outer\n",
      // Twice as large inside, halved outside.
      "push\nscale 2 2 2\nsphere 1 0 0 0\nnamed_object it\npop\n" + matrix + "scale 0.5 0.5 0.5\ninstance it\n"};
  RenderSettings settings;
  settings.layers = {Layer::normal, Layer::depth};
  const double k = std::tan(20 * 3.14159265358979 / 180);
  for (const std::string& text : cases) {
    const Picture3 picture = render_text(fmt::format("image_size {0} {0}\nfov 40\n", pixels) + text, settings);
    const ZeroedVector<float> normals = picture.film.layer(Layer::normal), depths = picture.film.layer(Layer::depth);
    int seen = 0;
    for (int y = 0; y < pixels; y++) {
      for (int x = 0; x < pixels; x++) {
        const Vec3 d{(x + 0.5 - pixels / 2.0) * 2 * k / pixels, (pixels / 2.0 - y - 0.5) * 2 * k / pixels, -1};
        Exact exact{};
        if (!cross_ellipsoid(m, d, exact)) continue;
        seen++;
        EXPECT_NEAR(depths[static_cast<std::size_t>(y * pixels + x)], exact.depth, 2e-5);
        EXPECT_LT(length(picture.value(normals, x, y) - exact.normal), 1e-4);
      }
    }
    EXPECT_GT(seen, 200) << text;
  }
}

// With the course's switch a ball keeps its radius and a box its axes; an instance still gets its full matrix.
TEST(Normals, CourseSpheresStayRound) {
  RenderSettings settings;
  settings.course = true;
  settings.layers = {Layer::depth};
  const std::string matrix = "translate 0 0 -6\nscale 2 2 2\n";
  const Picture3 direct = render_text(look({}, {0, 0, -1}) + matrix + "sphere 1 0 0 0\n", settings);
  EXPECT_NEAR(direct.film.layer(Layer::depth)[0], 5, 1e-5);
  const Picture3 instance =
      render_text(look({}, {0, 0, -1}) + "sphere 1 0 0 0\nnamed_object it\n" + matrix + "instance it\n", settings);
  EXPECT_NEAR(instance.film.layer(Layer::depth)[0], 4, 1e-5);
}

}  // namespace
}  // namespace penumbra::test
