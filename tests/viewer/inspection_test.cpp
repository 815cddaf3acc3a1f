#include "viewer/inspection.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "base/test_folder.hpp"
#include "rendering/isa.hpp"
#include "viewer/growing_picture.hpp"

namespace penumbra {
namespace {

const std::string scene_text = R"(image_size 40 30
rays_per_pixel 4
lens 0.2 5
disk_light 2 5 -2 1 0 -1 0 1 1 1
point_light 0 9 0 0.2 0.2 0.2
glossy 0.8 0.7 0.6 0.1 0.1 0.1 10 0.3 0.1
sphere 1 0 0 -5
moving_object 0.5 0 0
sphere 50 0 -51 -5
)";

class InspectionTest : public testing::Test {
 protected:
  // The picture after `rays` rays per pixel.
  Refinement picture_of(const PictureOptions& options, std::uint32_t rays, const std::string& text = scene_text) {
    test::put_content(folder_ / "a.cli", text);
    Refinement picture;
    picture.loaded = std::make_shared<const LoadedScene>(load_scene(folder_ / "a.cli", {}));
    BuiltWorld world;
    GrowingPicture growing(*picture.loaded, options, world, 1);
    RenderState state;
    growing.prepare({0, rays, rays});
    growing.draw(kernel_, 1, state);
    growing.keep();
    picture.rays = rays;
    picture.sides.push_back(growing.side());
    return picture;
  }

  test::TestFolder folder_;
  const Kernel& kernel_ = *usable_kernels().back();
};

TEST_F(InspectionTest, TextIsTheOneOfItsCommand) {
  PictureOptions options;
  options.sampler = Pattern::jittered;
  options.gloss = {{1, 0.3}};
  options.without.add(Effect::motion);
  const Refinement picture = picture_of(options, 12);
  for (const InspectedSample at : {InspectedSample{0, 20, 15, 0}, {0, 20, 15, 11}, {0, 3, 29, 5}}) {
    const Inspection inspection = inspect(picture, kernel_, at);
    const std::string program = std::string(PENUMBRA_PROGRAM).substr(0, std::string(PENUMBRA_PROGRAM).rfind('/') + 1);
    const auto result = test::run_program(program + inspection.command);
    EXPECT_EQ(result.exit_code, 0) << inspection.command << result.output;
    EXPECT_EQ(result.output, inspection.text) << inspection.command;
  }
}

TEST_F(InspectionTest, CommandNamesAnyFile) {
  Refinement picture = picture_of({}, 2);
  LoadedScene loaded = *picture.loaded;
  loaded.path = folder_ / "Anna's $scene.cli";
  std::filesystem::copy_file(folder_ / "a.cli", loaded.path);
  picture.loaded = std::make_shared<const LoadedScene>(std::move(loaded));
  const Inspection inspection = inspect(picture, kernel_, {0, 20, 15, 1});
  const std::string program = std::string(PENUMBRA_PROGRAM).substr(0, std::string(PENUMBRA_PROGRAM).rfind('/') + 1);
  EXPECT_EQ(test::run_program(program + inspection.command).output, inspection.text) << inspection.command;
}

TEST_F(InspectionTest, SamplesAddUpToThePixel) {
  const Refinement picture = picture_of({}, 16);
  const RefinedSide& side = picture.sides.front();
  double sum = 0;
  for (std::uint32_t i = 0; i < 16; i++) {
    sum += value_in_film(*side.frame, inspect(picture, kernel_, {0, 20, 15, i}).tree)[0];
  }
  const Inspection inspection = inspect(picture, kernel_, {0, 20, 15, 0});
  EXPECT_NEAR(sum / 16, inspection.so_far[0], 1e-7);
  for (std::size_t c = 0; c < 3; c++) EXPECT_EQ(inspection.so_far[c], side.image.rgb[3 * (15 * 40 + 20) + c]);
}

TEST_F(InspectionTest, PlotsEveryDistribution) {
  const Refinement picture = picture_of({}, 64);
  const Inspection inspection = inspect(picture, kernel_, {0, 20, 15, 0});
  std::vector<std::string> names;
  for (const DotPlot& plot : inspection.plots) names.push_back(plot.name);
  EXPECT_EQ(names, (std::vector<std::string>{"in the pixel", "on the lens", "in time", "on light 1"}));
  ASSERT_GT(inspection.shown, 0u);
  for (const DotPlot& plot : inspection.plots) {
    EXPECT_FALSE(plot.dots.empty()) << plot.name;
    for (const SampleDot& dot : plot.dots) {
      EXPECT_GE(dot.u, plot.low - 1e-4) << plot.name;
      EXPECT_LE(dot.u, 1 + 1e-4) << plot.name;
      if (plot.low < 0) {
        EXPECT_LE(dot.u * dot.u + dot.v * dot.v, 1 + 1e-3) << plot.name << " is a disk";
      }
    }
  }
}

// The plot of a light is that of its random numbers, whatever the angle between its edges.
TEST_F(InspectionTest, PlotsTheSquareOfAParallelogram) {
  std::string text = scene_text;
  const std::string disk = "disk_light 2 5 -2 1 0 -1 0 1 1 1";
  const Refinement picture =
      picture_of({}, 64, text.replace(text.find(disk), disk.size(), "quad_light 2 5 -2 1 0 0 0.7 0.3 0.4 1 1 1"));
  const Inspection inspection = inspect(picture, kernel_, {0, 20, 15, 0});
  const DotPlot& plot = inspection.plots.at(3);
  ASSERT_EQ(plot.name, "on light 1");
  ASSERT_EQ(plot.dots.size(), inspection.shown);
  std::vector<float> u(inspection.shown), v(inspection.shown);
  kernel_.sample_points(*picture.sides.front().frame, 20, 15, first_light_radius, u, v);
  for (std::size_t i = 0; i < plot.dots.size(); i++) {
    EXPECT_NEAR(plot.dots[i].u, 2 * u[i] - 1, 1e-4);
    EXPECT_NEAR(plot.dots[i].v, 2 * v[i] - 1, 1e-4);
  }
}

}  // namespace
}  // namespace penumbra
