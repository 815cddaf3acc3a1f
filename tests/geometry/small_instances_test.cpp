// Small instances are replaced by their shapes; whoever looks must not see it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/world.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

std::string tower(const std::string& part, const std::string& placed) {
  return "image_size 40 30\nrays_per_pixel 4\nfov 50\nlight 4 6 4 1 1 1\nshutter 0 0.5\n"
         "surface 0.6 0.4 0.3 0.1 0 0 0.3 0.3 0.3 20 0.2\n" +
         part + "named_object part\npush\ntranslate 0 -0.4 -4\nrotate 25 1 2 3\n" + placed + "pop\n";
}
const std::string shapes = R"(begin_list
sphere 0.4 0 0 0
box 0.3 -0.3 -0.3 0.9 0.3 0.3
cylinder 0.2 -0.6 0 -0.5 0.5
moving_sphere 0.2 0 0.6 0 0 0.9 0
begin
vertex -0.5 -0.5 0.4
vertex 0.5 -0.5 0.4
vertex 0 0.5 0.4
end
end_list
)";

World world_of(const std::string& text) { return build_world(scene_from(text), {}); }

std::size_t instances_left(const World& world) {
  return static_cast<std::size_t>(
      std::ranges::count_if(world.leaves, [](const Leaf& leaf) { return leaf.kind == LeafKind::instance; }));
}

// Spheres that nobody sees make a definition too large to be taken apart.
std::string enlarged(const std::string& part) {
  std::string text = part.substr(0, part.size() - std::string("end_list\n").size());
  for (int i = 0; i < 70'000; i++) text += "sphere 0.001 0 1000 0\n";
  return text + "end_list\n";
}

TEST(SmallInstances, LookTheSameTakenApart) {
  for (const std::string placed :
       {"instance part\n", "scale -1 0.7 1.2\ninstance part\n", "instance part\nmoving_object 0.3 0.1 0\n",
        "instance part\ntranslate 0 0.7 0\nscale 0.5 0.5 0.5\ninstance part\n"}) {
    const std::string small = tower(shapes, placed), large = tower(enlarged(shapes), placed);
    EXPECT_GT(instances_left(world_of(large)), 0u);
    const Picture3 apart = render_text(small), whole = render_text(large);
    int different = 0;
    for (int y = 0; y < 30; y++) {
      for (int x = 0; x < 40; x++) different += length(apart.at(x, y) - whole.at(x, y)) > 1e-3;
    }
    EXPECT_LE(different, 6) << placed << "rounding moves edges";
  }
}

TEST(SmallInstances, AreTakenApartThroughAllLevels) {
  const std::string nested = tower(
      "begin_list\nsphere 0.1 0 0 0\nsphere 0.1 1 0 0\nend_list\nnamed_object pair\n"
      "begin_list\ninstance pair\ntranslate 0 1 0\ninstance pair\nend_list\n",
      "instance part\n");
  const World world = world_of(nested);
  EXPECT_EQ(instances_left(world), 0u);
  EXPECT_EQ(world.leaves.size(), 4u);
  EXPECT_EQ(world.counts, (World::Counts{.shapes = 2, .triangles = 0, .instances = 3}));
}

TEST(SmallInstances, KeepTheirSpaceWhereItShows) {
  EXPECT_EQ(instances_left(world_of(tower("marble\n" + shapes, "instance part\n"))), 1u) << "textures follow it";
  EXPECT_EQ(instances_left(world_of(tower(shapes, "instance part\nmoving_object 1 0 0\n"))), 1u)
      << "its bounds are narrower than those of its shapes";
}

// Many instances of a large object stay what they are: they are there to save memory.
TEST(SmallInstances, AreNotTakenApartWhereThereAreTooMany) {
  std::string many;
  for (int i = 0; i < 20'000; i++) many += fmt::format("translate 0.01 0 0\ninstance part\n");
  const World world = world_of(tower(shapes, many));
  EXPECT_EQ(instances_left(world), 20'000u);
}

}  // namespace
}  // namespace penumbra::test
