// Solid textures: the space in which one is fixed, and that no lane sees its neighbours.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>

#include "base/test_scale.hpp"
#include "tracing/texture_points.hpp"

namespace penumbra::test {
namespace {

// Every instruction set, and every company of other points, gives the same bits.
TEST(Texture, PointsAreOnTheirOwn) {
  Points points = random_points(scaled(20011, 1003), 30);
  for (const double x : {0.0, 1e-30, 1.0, -1.0, 1e6, -3e9, 1e30}) points.add(x, -x, x / 3);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  Points shuffled;
  for (const std::size_t i : order) shuffled.add(points.x[i], points.y[i], points.z[i]);
  for (const LaneFunction function :
       {LaneFunction::wood_red, LaneFunction::wood_green, LaneFunction::wood_blue, LaneFunction::marble,
        LaneFunction::stone_red, LaneFunction::stone_green, LaneFunction::stone_blue, LaneFunction::stone_border}) {
    const std::vector<float> first = values(function, points, *usable_kernels().front());
    for (const Kernel* kernel : usable_kernels()) {
      const std::vector<float> straight = values(function, points, *kernel),
                               mixed = values(function, shuffled, *kernel);
      int different = 0;
      for (std::size_t i = 0; i < order.size(); i++) {
        const auto expected = std::bit_cast<std::uint32_t>(first[order[i]]);
        different += expected != std::bit_cast<std::uint32_t>(straight[order[i]]);
        different += expected != std::bit_cast<std::uint32_t>(mixed[i]);
      }
      EXPECT_EQ(different, 0) << kernel->isa << " function " << static_cast<int>(function);
    }
  }
}

TEST(Texture, PicturesAreTheSameForEveryInstructionSet) {
  const std::string text =
      "image_size 61 47\nrays_per_pixel 5\nlight 3 5 2 1 1 1\n"
      "wood\nsphere 0.8 -1 0.4 -4\nmarble\nsphere 0.8 0.9 0.5 -4\nstone\nsphere 0.8 0 -0.7 -3.5\nnoise 3\n"
      "box -2 -2 -6 2 -1.5 -3\nwood\nbegin\nvertex -4 -4 -7\nvertex 4 -4 -7\nvertex 0 5 -7\nend\n";
  RenderSettings settings;
  settings.kernel = usable_kernels().front();
  const Picture3 first = render_text(text, settings);
  for (const Kernel* kernel : usable_kernels()) {
    settings.kernel = kernel;
    EXPECT_EQ(render_text(text, settings).color, first.color) << kernel->isa;
  }
}

// What is seen straight on, in the light of a lamp behind the eye, is the diffuse colour itself.
Vec3 seen(const std::string& ball, Vec3 point, Vec3 outward) {
  return color_of(look(point + outward * 2, -outward) + "light " + numbers(point + outward * 5) + " 1 1 1\n" + ball);
}

Vec3 texture_at(const std::string& name, Vec3 p) {
  Points point;
  point.add(p.x, p.y, p.z);
  if (name == "marble") return Vec3{1, 1, 1} * double{values(LaneFunction::marble, point)[0]};
  const auto& channels = name == "wood" ? wood_channels : stone_channels;
  return {values(channels[0], point)[0], values(channels[1], point)[0], values(channels[2], point)[0]};
}

// A unit ball in many directions d: seen at `world(d)` with the normal `normal(d)`, its colour is that of the block at
// `block(d)`. Where an edge runs through the point, rounding may choose the other side: at most one point in twenty.
template <typename World, typename Normal, typename Block>
void expect_texture(const std::string& name, const std::string& ball, World world, Normal normal, Block block) {
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  constexpr int count = scaled(40, 20);
  int different = 0;
  for (int i = 0; i < count; i++) {
    const double x = any(random), y = any(random);
    const Vec3 d = normalize({x, y, any(random)});
    const Vec3 difference = abs(seen(ball, world(d), normal(d)) - texture_at(name, block(d)));
    different += max_component(difference) > 2e-3;
  }
  EXPECT_LE(different, count / 20) << ball;
}

TEST(Texture, IsCutFromTheSpaceOfTheDefinition) {
  const auto same = [](Vec3 d) { return d; };
  const auto quarter = [](Vec3 d) { return Vec3{-d.y, d.x, d.z}; };  // rotatez 90
  for (const std::string name : {"wood", "marble", "stone"}) {
    const std::string surface = "diffuse 0.9 0.1 0.1 0 0 0\n" + name + "\n";
    expect_texture(name, surface + "sphere 1 0 0 0\n", same, same, same);
    // The matrix of the definition moves the ball through the block.
    const auto shifted = [](Vec3 d) { return d + Vec3{0.4, -2, 1.3}; };
    expect_texture(name, surface + "translate 0.4 -2 1.3\nsphere 1 0 0 0\n", shifted, same, shifted);
    expect_texture(name, surface + "rotatez 90\nsphere 1 0 0 0\n", same, same, same);
    // An instance carries the block along, whatever it holds.
    const auto placed = [&](Vec3 d) { return quarter(d) + Vec3{3, 1, 0}; };
    const std::string place = "named_object it\ntranslate 3 1 0\nrotatez 90\ninstance it\n";
    expect_texture(name, surface + "sphere 1 0 0 0\n" + place, placed, quarter, same);
    expect_texture(name, surface + "begin_list\nsphere 1 0 0 0\nend_list\n" + place, placed, quarter, same);
    // So does motion.
    const auto moved = [](Vec3 d) { return d + Vec3{0.5, 0, -1}; };
    expect_texture(name, "shutter 0.5 0.5\n" + surface + "sphere 1 0 0 0\nmoving_object 1 0 -2\n", moved, same, same);
  }
}

}  // namespace
}  // namespace penumbra::test
