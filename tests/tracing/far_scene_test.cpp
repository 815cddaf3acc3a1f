// A scene far from the origin is as good as the same scene at the origin.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "rendering/ray_tree.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

std::string scene_at(Vec3 place) {
  const auto at = [&](double x, double y, double z) {
    return fmt::format("{} {} {}", place.x + x, place.y + y, place.z + z);
  };
  return fmt::format(
      "image_size 60 45\nfov 50\nrays_per_pixel 4\nmax_depth 6\nbackground .2 .4 .8\neye {}\nlight {} .6 .6 .6\n"
      "disk_light {} 0.5 0 -1 0 .5 .5 .5\nspotlight {} 0 -1 -1 20 40 .3 .3 .3\n"
      "diffuse .7 .7 .6 .1 .1 .1\nbox {} {}\nsphere 1 {}\nreflective .2 .2 .2 0 0 0 .7\nsphere 0.75 {}\n"
      "translucent 0 0 0 0 0 0 1 0 0 1 1.5 0\nbox {} {}\ndiffuse .8 .2 .2 .1 .1 .1\nbegin\nvertex {}\nvertex {}\n"
      "vertex {}\nend\nsphere 0.5 0 0 0\nnamed_object ball\ntranslate {}\nscale 1 0.5 1\ninstance ball\n",
      at(0, 1, 4), at(3, 5, 2), at(-1, 4, -2), at(0, 4, 0), at(-20, -2, -20), at(20, -1, 20), at(-1.5, 0, -3),
      at(1, 0, -3), at(-0.5, -1, -2), at(0.5, 0, -1), at(-3, -1, -5), at(3, -1, -5), at(0, 3, -5), at(1.5, -0.75, 0));
}

TEST(FarScene, LooksAsAtTheOrigin) {
  const Picture3 near = render_text(scene_at({}));
  for (const Vec3 place : {Vec3{1000, -777, 500}, Vec3{-16384, 4096, 65536}}) {
    const Picture3 far = render_text(scene_at(place));
    int different = 0;
    for (std::size_t i = 0; i < near.color.size(); i += 3) different += std::abs(near.color[i] - far.color[i]) > 0.01f;
    EXPECT_LE(different, 10) << "of " << near.color.size() / 3 << " at " << place.x << " " << place.y << " " << place.z;
  }
}

// What is said of rays is in the coordinates of the scene.
TEST(FarScene, RaysAreToldInItsCoordinates) {
  const Frame frame = frame_from(scene_from(scene_at({1000, -777, 500})));
  const RayTree tree = trace_sample(frame, *usable_kernels().back(), 30, 30, 0, 4);
  const std::string text = ray_tree_text(frame, tree, 30, 30, 0);
  EXPECT_NE(text.find("eye ray: from 1000 -776 504 toward"), std::string::npos) << text;
}

}  // namespace
}  // namespace penumbra::test
