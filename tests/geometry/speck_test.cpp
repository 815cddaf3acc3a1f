// No surface is in its own way: a convex object in the light looks the same with shadows and without, wherever the
// light comes from the front (N.L > 0.05), even when the object is only 1e-4 of its coordinates in size.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "base/test_scale.hpp"
#include "geometry/random_scene.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

struct Form {
  const char* name;
  std::string text;  // of the size of the unit ball, round the origin
};

std::string mesh_text(int levels) {
  std::string text;
  const std::vector<Vec3> corners = icosphere(levels);
  for (std::size_t i = 0; i < corners.size(); i++) {
    if (i % 3 == 0) text += "begin\n";
    text += fmt::format("vertex {} {} {}\n", corners[i].x, corners[i].y, corners[i].z);
    if (i % 3 == 2) text += "end\n";
  }
  return text;
}

std::vector<Form> forms() {
  return {{"sphere", "sphere 1 0 0 0\n"},
          {"box", "box -0.6 -0.5 -0.4 0.6 0.5 0.4\n"},
          {"cylinder", "cylinder 0.6 0 0 -0.7 0.7\n"},
          {"cone", "cone 0 -0.5 0 1.1 0.6\n"},
          {"turned box", "push\nrotate 40 1 2 3\nbox -0.6 -0.5 -0.4 0.6 0.5 0.4\npop\n"},
          {"turned cylinder", "push\nrotate 70 1 2 3\ncylinder 0.6 0 0 -0.7 0.7\npop\n"},
          {"turned cone", "push\nrotate 160 1 2 3\ncone 0 -0.5 0 1.1 0.6\npop\n"},
          {"ellipsoid", "push\nrotate 30 3 1 2\nscale 1 0.5 0.7\nsphere 1 0 0 0\npop\n"},
          {"triangles", mesh_text(1)},
          {"mesh", mesh_text(4)}};
}

// The form, `size` large, at a far place: set there by the matrix, or by an instance of it.
std::string scene_text(const Form& form, Vec3 place, double size, bool instance, Vec3 light) {
  const std::string matrix =
      fmt::format("translate {} {} {}\nscale {} {} {}\n", place.x, place.y, place.z, size, size, size);
  const Vec3 eye = place + Vec3{0.9, 0.7, 2.4} * size;
  const Vec3 lamp = place + light * size;
  const int pixels = scaled(240, 40);
  std::string text = fmt::format("image_size {} {}\nfov 75\neye {} {} {}\nlight {} {} {} 1 1 1\n", pixels, pixels,
                                 eye.x, eye.y, eye.z, lamp.x, lamp.y, lamp.z);
  text += "surface 1 1 1\n";
  if (!instance) return text + matrix + form.text;
  return text + "begin_list\n" + form.text + "end_list\nnamed_object it\n" + matrix + "instance it\n";
}

TEST(Specks, ConvexObjectsDoNotShadowTheirLitSide) {
  for (const Form& form : forms()) {
    for (const bool instance : {false, true}) {
      for (const Vec3 place : {Vec3{0, 0, -5}, Vec3{100, -60, -80}, Vec3{0, 0, -100}, Vec3{-33, 100, 71}}) {
        const double size = max_component(abs(place)) * 1e-4;
        for (const Vec3 light : {Vec3{4, 3, 6}, Vec3{-20, 7, 9}}) {
          const std::string text = scene_text(form, place, size, instance, light);
          RenderSettings without;
          without.shadows = false;
          const Picture3 shadowed = render_text(text), plain = render_text(text, without);
          int lit = 0, specks = 0;
          for (std::size_t i = 0; i < plain.color.size(); i += 3) {
            if (!(plain.color[i] > 0.05f)) continue;
            lit++;
            specks += shadowed.color[i] != plain.color[i];
          }
          EXPECT_GT(lit, scaled(400, 10)) << form.name;
          EXPECT_EQ(specks, 0) << form.name << (instance ? " instance" : "") << " at " << place.x << " " << place.y
                               << " " << place.z << ", " << lit << " lit pixels";
        }
      }
    }
  }
}

// The mirror direction and the way through start as cleanly: seen in a perfect mirror ball or through a clear sheet,
// the background has no specks.
TEST(Specks, ReflectedRaysLeaveConvexMirrors) {
  for (const Form& form : forms()) {
    const Vec3 place{100, -60, -80};
    std::string text = scene_text(form, place, 0.01, false, {4, 3, 6});
    text.replace(text.find("surface 1 1 1"), 13, "background 1 1 1\nreflective 0 0 0 0 0 0 1");
    const Picture3 picture = render_text(text);
    int specks = 0;
    for (const float v : picture.color) specks += v != 1.0f;
    EXPECT_EQ(specks, 0) << form.name;
  }
}

}  // namespace
}  // namespace penumbra::test
