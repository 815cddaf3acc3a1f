// Directions are the same whatever the length of the vectors that say them, however long or short.
#include <gtest/gtest.h>

#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

const std::string ball = "image_size 12 9\nfov 40\ndiffuse 1 .5 .25 0 0 0\nsphere 1 0 0 -5\n";
const std::string light = "light 3 4 0 1 1 1\n";
const std::vector<std::string> lengths = {"1e-44", "1e-30", "1e-20", "1e20", "1e30", "1e38"};

// The mean of the colour differs by no more than rounding does, and is not black.
void expect_same_picture(const std::string& a, const std::string& b) {
  const Picture3 first = render_text(a), second = render_text(b);
  EXPECT_GT(max_component(first.mean()), 0.01) << a;
  for (std::size_t i = 0; i < first.color.size(); i++) ASSERT_NEAR(first.color[i], second.color[i], 2e-4) << b;
}

TEST(Length, OfTheCamerasAxes) {
  for (const std::string& l : lengths) {
    const std::string axes = fmt::format("uvw {0} 0 0 0 {0} 0 0 0 {0}\n", l);
    expect_same_picture(ball + light, ball + light + axes);
    const std::string lens = "rays_per_pixel 16\nlens 0.3 4\n";
    expect_same_picture(ball + light + lens, ball + light + lens + axes);
  }
}

TEST(Length, OfTheWayToALight) {
  for (const char* kind : {"light {0} {0} 0 1 1 1\n", "spotlight {0} {0} 0 -1 -1 0 10 20 1 1 1\n",
                           "disk_light {0} {0} 0 0 1 1 0 1 1 1\n", "quad_light {0} {0} 0 1 0 0 0 0 1 1 1 1\n"}) {
    const std::string far = fmt::format(fmt::runtime(kind), "1e12");
    for (const char* distance : {"1e17", "1e19", "1e20", "1e30", "3e38"}) {
      expect_same_picture(ball + far, ball + fmt::format(fmt::runtime(kind), distance));
    }
  }
}

TEST(Length, OfTheDirectionOfALight) {
  for (const std::string& l : lengths) {
    const auto spot = [](const std::string& x) {
      return fmt::format("spotlight 3 4 0 -{0} -{0} -{0} 30 60 1 1 1\n", x);
    };
    expect_same_picture(ball + spot("1"), ball + spot(l));
    const auto disk = [](const std::string& x) { return fmt::format("disk_light 3 4 0 1 {0} {0} 0 1 1 1\n", x); };
    expect_same_picture(ball + disk("1"), ball + disk(l));
  }
}

TEST(Length, OfTheAxisOfARotation) {
  const std::string box = "image_size 12 9\n" + light;
  for (const std::string& l : lengths) {
    const auto turned = [&box](const std::string& x) {
      return box + fmt::format("translate 0 0 -5\nrotate 40 {0} {0} 0\nbox -1 -1 -1 1 1 1\n", x);
    };
    expect_same_picture(turned("1"), turned(l));
  }
}

TEST(Length, OfWhatIsAddedToAMirrorDirection) {
  const auto floor = [](const std::string& radius) {
    return "image_size 12 9\nrays_per_pixel 16\nbackground 1 1 1\nglossy 0 0 0 0 0 0 1 1 " + radius +
           "\nbox -9 -2 -9 9 -1 9\n";
  };
  expect_same_picture(floor("1e9"), floor("1e20"));
  expect_same_picture(floor("1e9"), floor("3e38"));
}

// The normals of what a matrix flattens or stretches.
TEST(Length, OfNormalsUnderAMatrix) {
  for (const std::string& group : {std::string("box -1 -1 -1 1 1 1\n"),
                                   std::string("begin_list\nbox -1 -1 -1 1 1 1\nbox -1 -1 -1 1 1 1\nend_list\n")}) {
    const auto flat = [&group](const std::string& by) {
      return "image_size 12 9\n" + light + group + "named_object o\ntranslate 0 0 -5\nrotate 30 1 1 0\nscale 1 1 " +
             by + "\ninstance o\n";
    };
    for (const char* by : {"1e-18", "1e-20", "1e-30"}) expect_same_picture(flat("1e-9"), flat(by));
  }
}

// A lens and a focus of any size: nothing is black.
TEST(Length, OfTheLens) {
  for (const char* lens : {"lens 1e-30 1e-30\n", "lens 1e-30 5\n", "lens .1 1e30\n", "camera_lens 1e-30 1 2e-30\n"}) {
    const std::string sky = "image_size 4 4\nrays_per_pixel 4\nbackground 1 1 1\n" + std::string(lens);
    expect_same_picture("image_size 4 4\nbackground 1 1 1\n", sky);
    const Picture3 picture = render_text(ball + light + "rays_per_pixel 16\n" + lens);
    EXPECT_EQ(picture.rays.not_finite.count, 0u) << lens;
    EXPECT_GT(picture.mean().x, 0.01) << lens;
  }
}

}  // namespace
}  // namespace penumbra::test
