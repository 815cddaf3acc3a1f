#include "rendering/ray_tree.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/test_folder.hpp"
#include "image/image_file.hpp"
#include "rendering/all_effects.hpp"
#include "rendering/pixel_list.hpp"
#include "rendering/render_text.hpp"

namespace penumbra {
namespace {

// One sample of one pixel, as the film holds it after only that sample was rendered.
std::array<float, 3> rendered_sample(const Frame& frame, const Kernel& kernel, int x, int y, std::uint32_t sample) {
  Plan plan;
  plan.crop = {x, y, x + 1, y + 1};
  Film film(plan.crop, {});
  RenderState state;
  render_samples(film, frame, kernel, plan, {sample, sample + 1}, state);
  film.set_samples(pixels_of(plan.crop).all(), 1);  // those before it were left out
  const ZeroedVector<float> color = film.color();
  return {color[0], color[1], color[2]};
}

std::array<float, 3> color_of(const RecordedRay& ray) { return {ray.came_back[0], ray.came_back[1], ray.came_back[2]}; }

void check_tree(const Frame& frame, const Kernel& kernel, int x, int y, std::uint32_t sample) {
  const RayTree tree =
      trace_sample(frame, kernel, x, y, sample, static_cast<std::uint32_t>(frame.settings.rays_per_pixel));
  ASSERT_FALSE(tree.rays.empty());
  EXPECT_EQ(tree.left_out, 0u);
  EXPECT_EQ(tree.rays.front().kind, RayKind::eye);
  for (std::size_t i = 0; i < tree.rays.size(); i++) {
    const RecordedRay& ray = tree.rays[i];
    EXPECT_LT(ray.parent, static_cast<int>(i));
    if (i > 0) {
      EXPECT_EQ(ray.depth, tree.rays[static_cast<std::size_t>(ray.parent)].depth + 1);
      EXPECT_EQ(ray.time, tree.rays.front().time) << "one time for all rays of a sample";
    }
    if (ray.kind == RayKind::shadow) continue;
    EXPECT_EQ(sum_of(tree, i), color_of(ray)) << "ray " << i;
  }
  EXPECT_EQ(value_in_film(frame, tree), rendered_sample(frame, kernel, x, y, sample));
  for (std::size_t c = 0; c < 3; c++) {
    const float seen = tree.rays.front().came_back[c];
    // Rays that go on alone are worth what all factors above them make together, which rounds in another order.
    EXPECT_NEAR(tree.color[c], seen, frame.chooses_branches ? 1e-6 * std::max(1.0f, seen) : 0);
  }
}

TEST(RayTree, SumIsTheSampleInTheFilm) {
  for (const Kernel* kernel : usable_kernels()) {
    const Frame frame = test::frame_from(test::scene_from(test::scene_text(8)));
    for (int y = 3; y < frame.settings.height; y += 7) {
      for (int x = 2; x < frame.settings.width; x += 5) {
        for (const std::uint32_t sample : {0u, 1u, 5u}) check_tree(frame, *kernel, x, y, sample);
      }
    }
  }
}

const std::string hall = R"(image_size 24 18
rays_per_pixel 8
max_depth 4
disk_light 2 5 0 0.7 0 -1 0 1 1 1
point_light -3 4 0 0.3 0.4 0.5
translucent 0.2 0.4 0.2 0.3 0.3 0.3 20 0.3 0.1 0.6 1.3 0.1
sphere 1 -0.6 0 -4
glossy 0.4 0.2 0.1 0.5 0.5 0.5 10 0.5 0.2
sphere 1 1.2 0 -5
diffuse 0.6 0.6 0.5 0.1 0.1 0.1
sphere 50 0 -51 -5
)";

TEST(RayTree, SeveralRaysOfAHit) {
  const Frame frame =
      test::frame_from(test::scene_from(hall + "reflection_rays 3\ntransmission_rays 2\nshadow_rays 4\n"));
  for (int x = 0; x < frame.settings.width; x += 3) check_tree(frame, *usable_kernels().back(), x, 9, 2);
}

TEST(RayTree, LightThatPassesAndNoShadows) {
  for (const bool shadows : {true, false}) {
    const Frame frame = test::frame_from(test::scene_from(hall), {.shadows = shadows, .transparent_shadows = true});
    for (int x = 0; x < frame.settings.width; x += 3) check_tree(frame, *usable_kernels().back(), x, 9, 2);
  }
}

TEST(RayTree, MeshOfEmbree) {
  std::string text =
      "image_size 20 20\nrays_per_pixel 21\ndisk_light 2 5 0 0.7 0 -1 0 1 1 1\n"
      "glossy 0.4 0.2 0.1 0.5 0.5 0.5 10 0.5 0.2\n";
  for (int i = 0; i < 80; i++) {
    for (int k = 0; k < 80; k++) {
      text += fmt::format("begin\nvertex {0} {1} -6\nvertex {2} {1} -6\nvertex {0} {3} {4}\nend\n", i * 0.1 - 4,
                          k * 0.1 - 4, i * 0.1 - 3.9, k * 0.1 - 3.9, -6 + 0.05 * ((i + k) % 3));
    }
  }
  const Frame frame = test::frame_from(test::scene_from(text));
  ASSERT_FALSE(frame.world.meshes.empty());
  for (const std::uint32_t sample : {0u, 7u, 8u, 20u}) check_tree(frame, *usable_kernels().back(), 10, 10, sample);
}

TEST(RayTree, TellsWhatItHit) {
  const Frame frame = test::frame_from(
      test::scene_from("image_size 3 3\npoint_light 0 0 0 1 1 1\npoint_light 0 9 -4 1 1 1\ndiffuse 1 0.5 0 0.25 0 0\n"
                       "sphere 1 0 0 -4\nsphere 1 0 4 -4\n"));
  const RayTree tree = trace_sample(frame, *usable_kernels().back(), 1, 1, 0, 1);
  ASSERT_EQ(tree.rays.size(), 2u) << "the second light is behind the sphere's horizon";
  EXPECT_EQ(tree.rays[0].distance, 3.0f);
  EXPECT_EQ(tree.rays[0].normal[2], 1.0f);
  EXPECT_EQ(tree.rays[0].ambient[0], 0.25f);
  EXPECT_EQ(tree.rays[1].kind, RayKind::shadow);
  EXPECT_FALSE(tree.rays[1].hit);
  EXPECT_NEAR(tree.rays[1].light_distance, 3, 1e-5);
  EXPECT_FLOAT_EQ(tree.rays[1].adds[0], 1.0f);
}

TEST(RayTree, KeepsNoMoreThanAsked) {
  const Frame frame = test::frame_from(test::scene_from(hall + "shadow_rays 100\n"));
  const RayTree tree = trace_sample(frame, *usable_kernels().back(), 12, 12, 0, 8, 10);
  EXPECT_EQ(tree.rays.size(), 10u);
  EXPECT_GT(tree.left_out, 80u);
}

// A tree of 2^100 rays.
TEST(RayTree, IsGivenUpWhereItHasNoEnd) {
  std::string text =
      "image_size 1 1\neye 0 0 9\nlight 0 9 0 1 1 1\nmax_depth 100\nshiny 0 0 0 0 0 0 0 0 0 1 .5 .5 1.5\n";
  for (int i = 0; i < 100; i++) text += fmt::format("sphere {} 0 0 0\n", 1 + 0.05 * i);
  const Frame frame = test::frame_from(test::scene_from(text));
  const RayTree tree = trace_sample(frame, *usable_kernels().back(), 0, 0, 0, 1, 10);
  EXPECT_TRUE(tree.given_up);
  EXPECT_EQ(tree.rays.size(), 10u);
  EXPECT_TRUE(ray_tree_text(frame, tree, 0, 0, 0).ends_with("more rays, not followed to the end\n"));
}

TEST(DebugPixelOption, PrintsTheTreeAndTheSampleOfThePicture) {
  const test::TestFolder folder;
  test::put_content(folder / "a.cli", hall);
  const std::string program = fmt::format("{} render {} ", PENUMBRA_PROGRAM, (folder / "a.cli").string());
  const auto tree = test::run_program(program + "--debug-pixel 10,9,0 --rays 1");
  EXPECT_EQ(tree.exit_code, 0) << tree.output;
  EXPECT_EQ(test::run_program(fmt::format("{} -o {} --quiet --rays 1", program, (folder / "a.exr").string())).exit_code,
            0);
  const ImageFile picture = read_image(folder / "a.exr");
  const float* rgb = &picture.image.rgb[3 * (9 * 24 + 10)];
  const std::string end = fmt::format("in the film {} {} {}\n", rgb[0], rgb[1], rgb[2]);
  EXPECT_TRUE(tree.output.ends_with(end)) << tree.output << "should end with " << end;
  EXPECT_TRUE(tree.output.starts_with("pixel 10,9, sample 0\neye ray: from 0 0 0 toward ")) << tree.output;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.cli", "a.exr"})) << "nothing was rendered";
}

TEST(DebugPixelOption, SaysWhatIsWrong) {
  const test::TestFolder folder;
  test::put_content(folder / "a.cli", hall);
  const std::string program = fmt::format("{} render {} --debug-pixel ", PENUMBRA_PROGRAM, (folder / "a.cli").string());
  for (const char* pixel : {"24,0,0", "0,18,0", "0,0,8"}) {
    const auto result = test::run_program(program + pixel);
    EXPECT_EQ(result.exit_code, 64) << result.output;
    EXPECT_NE(result.output.find("24x18 pixels with 8 samples"), std::string::npos) << result.output;
  }
  EXPECT_NE(test::run_program(program + "1,2").output.find("expected x,y,sample"), std::string::npos);
}

}  // namespace
}  // namespace penumbra
