// Samples that are infinite or not a number: counted, named, and shown as the largest value, in whatever order and
// company they are rendered.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/test_folder.hpp"
#include "image/image_file.hpp"
#include "rendering/film_values.hpp"
#include "rendering/ray_tree.hpp"
#include "rendering/render_adaptive.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

// The light times the surface is too large for single precision; the background is not.
const std::string scene_text =
    "image_size 40 30\nrays_per_pixel 9\nfov 40\nbackground 1 2 3\nlight 9 9 9 1e20 1e20 1\n"
    "diffuse 1e20 1e20 0.5 0 0 0\nsphere 1 0 0 -5\n";

TEST(NotFinite, IsCountedAndTheFirstIsNamed) {
  const Scene scene = scene_from(scene_text);
  const Frame frame = frame_from(scene);
  NotFiniteSamples expected;
  for (std::uint32_t y = 0; y < 30; y++) {
    for (std::uint32_t x = 0; x < 40; x++) {
      for (std::uint32_t sample = 0; sample < 9; sample++) {
        const RayTree tree =
            trace_sample(frame, *usable_kernels().back(), static_cast<int>(x), static_cast<int>(y), sample, 9);
        if (!(tree.rays.front().came_back[0] < 3e38f)) expected += {1, x, y, sample};
      }
    }
  }
  ASSERT_GT(expected.count, 100u);
  for (const Kernel* kernel : usable_kernels()) {
    for (const Layers& layers : {Layers{}, all_layers}) {
      for (const int threads : {1, 3}) {
        RenderSettings settings;
        settings.kernel = kernel;
        settings.layers = layers;
        settings.threads = threads;
        const NotFiniteSamples found = render_scene(scene, settings).rays.not_finite;
        EXPECT_EQ(found.count, expected.count);
        EXPECT_EQ(std::tie(found.x, found.y, found.sample), std::tie(expected.x, expected.y, expected.sample));
      }
    }
  }
  EXPECT_EQ(render_text("light 0 0 0 1 1 1\nsphere 1 0 0 -5\n").rays.not_finite.count, 0u);
}

TEST(NotFinite, IsTheLargestValue) {
  const Picture3 picture = render_text(scene_text);
  const Vec3 center = picture.at(22, 13), corner = picture.at(0, 0);
  EXPECT_EQ(center.x, 3e38f);
  EXPECT_EQ(center.y, 3e38f);
  EXPECT_EQ(center.z, 0) << "each channel by itself; 1 is less than the quantum of so bright a scene";
  EXPECT_EQ(corner, Vec3{});
}

// The sums stay exact: the order of samples does not show.
TEST(NotFinite, LeavesNoTraceOfTheOrder) {
  const Scene scene = scene_from(scene_text);
  for (const Layers& layers : {Layers{}, all_layers}) {
    RenderSettings settings;
    settings.layers = layers;
    settings.threads = 1;
    const FilmValues whole = values_of(render_scene(scene, settings).film);
    for (const Kernel* kernel : usable_kernels()) {
      settings.kernel = kernel;
      settings.threads = 3;
      EXPECT_EQ(values_of(render_scene(scene, settings).film), whole);
    }
  }
}

class NotFiniteOption : public testing::Test {
 protected:
  NotFiniteOption() { put_content(folder_ / "scene.cli", scene_text); }
  std::string render(const std::string& arguments) const {
    const ProgramResult result = run_program(
        fmt::format("cd '{}' && '{}' render scene.cli {}", folder_.path().string(), PENUMBRA_PROGRAM, arguments));
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return result.output;
  }

  TestFolder folder_;
};

TEST_F(NotFiniteOption, OneWarningTellsHowToLookAtTheFirst) {
  const std::string said = render("-o a.png --stats stats.json");
  const NotFiniteSamples expected = render_text(scene_text).rays.not_finite;
  EXPECT_NE(said.find(fmt::format("penumbra: warning: {} of 10800 samples are not finite", expected.count)), said.npos)
      << said;
  const std::string look = fmt::format("--debug-pixel {},{},{}", expected.x, expected.y, expected.sample);
  EXPECT_NE(said.find(look), said.npos) << said;
  EXPECT_EQ(nlohmann::json::parse(content_of(folder_ / "stats.json"))["samples_not_finite"], expected.count);
  EXPECT_NE(render("-o a.png " + look).find("inf"), std::string::npos);
  EXPECT_EQ(read_image(folder_ / "a.png").image.rgb[3 * (13 * 40 + 22)], 1);
  EXPECT_EQ(render("-o a.png --quiet"), "");
}

TEST_F(NotFiniteOption, TheBytesAreTheSameInParts) {
  for (const std::string options : {"--aov variance,depth", "--noise 0.05"}) {
    render("--quiet --threads 1 -o whole.exr " + options);
    render("--quiet --threads 3 -o again.exr " + options);
    render("--quiet --shard 0/2 -o part0.exr " + options);
    render("--quiet --shard 1/2 -o part1.exr " + options);
    run_program(fmt::format("cd '{}' && '{}' merge part0.exr part1.exr -o merged.exr", folder_.path().string(),
                            PENUMBRA_PROGRAM));
    EXPECT_TRUE(content_of(folder_ / "whole.exr") == content_of(folder_ / "again.exr")) << options;
    EXPECT_TRUE(content_of(folder_ / "whole.exr") == content_of(folder_ / "merged.exr")) << options;
  }
}

}  // namespace
}  // namespace penumbra::test
