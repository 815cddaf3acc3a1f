// The options that make what the window shows repeatable on the command line of `penumbra render`.
#include "picture/picture_options.hpp"
#include "picture/option_table.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "base/test_folder.hpp"
#include "image/image_file.hpp"
#include "picture/develop.hpp"

namespace penumbra {
namespace {

using test::content_of;
using test::put_content;

const std::string scene_text = R"(image_size 30 20
rays_per_pixel 5
lens 0.2 5
shutter 0 0.5
disk_light 2 5 -2 1 0 -1 0 1 1 1
glossy 0.8 0.1 0.1 0.3 0.3 0.3 10 0.3 0.1
sphere 1 -1 0 -5
moving_object 0.5 0.5 0
translucent 0.1 0.1 0.8 0.3 0.3 0.3 10 0.1 0.05 0.6 1.1 0.3
sphere 1 1 0 -4
)";

class PictureOptionsTest : public testing::Test {
 protected:
  PictureOptionsTest() { put_content(folder_ / "a.cli", scene_text); }

  std::string picture(const std::string& scene, const std::string& options) {
    put_content(folder_ / "it.cli", scene);
    const auto result =
        test::run_program(fmt::format("{} render {} -o {} --quiet {}", PENUMBRA_PROGRAM, (folder_ / "it.cli").string(),
                                      (folder_ / "it.exr").string(), options));
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return result.exit_code == 0 ? std::string() : result.output;
  }
  ZeroedVector<float> pixels(const std::string& scene, const std::string& options) {
    picture(scene, options);
    return read_image(folder_ / "it.exr").image.rgb;
  }
  std::string with(const std::string& old_line, const std::string& new_line) const {
    std::string text = scene_text;
    return text.replace(text.find(old_line), old_line.size(), new_line);
  }
  std::string problem(const std::string& options) {
    const auto result =
        test::run_program(fmt::format("{} render {} -o {} {}", PENUMBRA_PROGRAM, (folder_ / "a.cli").string(),
                                      (folder_ / "x.png").string(), options));
    EXPECT_EQ(result.exit_code, 64) << result.output;
    return result.output;
  }

  test::TestFolder folder_;
};

TEST_F(PictureOptionsTest, SayTheSameAsTheSceneWould) {
  const auto plain = pixels(scene_text, "");
  const auto check = [&](const std::string& old_line, const std::string& new_line, const std::string& option) {
    const auto wanted = pixels(with(old_line, new_line), "");
    EXPECT_EQ(pixels(scene_text, option), wanted) << option;
    EXPECT_NE(wanted, plain) << option << " changes nothing";
  };
  check("lens 0.2 5", "lens 0.4 3.5", "--lens 0.4,3.5");
  check("lens 0.2 5", "lens 0 5", "--without lens");
  check("shutter 0 0.5", "shutter 0.25 2", "--shutter 0.25,2");
  check("shutter 0 0.5", "shutter 0 0", "--without motion");
  check("-2 1 0 -1", "-2 0.3 0 -1", "--disk-radius 0.3");
  check("-2 1 0 -1", "-2 0.3 0 -1", "--disk-radius 1:0.3");
  check("-2 1 0 -1", "-2 0 0 -1", "--without disk-lights");
  check("10 0.3 0.1\n", "10 0.3 0.4\n", "--gloss 1:0.4");
  check("0.6 1.1 0.3", "0.6 1.1 0.1", "--blur 0.1");
  check("0.6 1.1 0.3", "0.6 1.1 0", "--without translucency");
}

TEST_F(PictureOptionsTest, LeaveThePointAtTheCentreOfALight) {
  const std::string disk = "disk_light 2 5 -2 1 0 -1 0 1 1 1", quad = "quad_light 2 5 -2 1 0 0 0.3 0 1 1 1 1";
  const auto points = pixels(with(disk, "point_light 2 5 -2 1 1 1"), "");
  EXPECT_EQ(pixels(with(disk, quad), "--without disk-lights"), points);
  EXPECT_NE(pixels(with(disk, quad), ""), points);
}

TEST_F(PictureOptionsTest, LaterRadiiWin) {
  EXPECT_EQ(pixels(scene_text, "--gloss 0.5,1:0.2,2:0.3"), pixels(scene_text, "--gloss 1:0.2,2:0.3"));
}

TEST_F(PictureOptionsTest, WithoutAntialiasingAllRaysGoThroughOnePlace) {
  const std::string plain = "image_size 30 20\npoint_light 0 9 0 1 1 1\ndiffuse 1 1 1 0 0 0\nsphere 1 0 0 -5\n";
  const auto jagged = pixels(plain, "--rays 16 --without antialiasing");
  EXPECT_EQ(jagged, pixels(plain, "--rays 1"));
  EXPECT_NE(jagged, pixels(plain, "--rays 16"));
  EXPECT_EQ(pixels(plain, "--course --rays 16 --without antialiasing"), pixels(plain, "--course --rays 1"));
}

TEST_F(PictureOptionsTest, ExposureDoubles) {
  const auto plain = pixels(scene_text, "");
  const auto brighter = pixels(scene_text, "--exposure 2");
  for (std::size_t i = 0; i < plain.size(); i++) ASSERT_EQ(brighter[i], 4 * plain[i]);
  EXPECT_NEAR(exposure_factor(1), std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(exposure_factor(-1), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(exposure_factor(-4), 0.25);
}

TEST_F(PictureOptionsTest, MetadataRepeatThePicture) {
  picture(scene_text,
          "--lens 0.31,4.7 --shutter 0.1,0.9 --gloss 0.2,1:0.3 --blur 2:0.05 --disk-radius 0.7 --without "
          "antialiasing,lens --exposure -1.5 --rays 3 --sampler halton --transparent-shadows --lens-model cone");
  const std::string first = content_of(folder_ / "it.exr");
  std::string options;
  for (const auto& [key, value] : read_image(folder_ / "it.exr").metadata) {
    if (key == "scene" || key == "version") continue;
    options += value == "yes" ? fmt::format(" --{}", key) : fmt::format(" --{}={}", key, value);
  }
  EXPECT_NE(options.find("--without=antialiasing,lens"), std::string::npos) << options;
  picture(scene_text, options);
  EXPECT_EQ(content_of(folder_ / "it.exr"), first) << options;
}

TEST_F(PictureOptionsTest, SayWhatTheyExpect) {
  EXPECT_NE(problem("--lens 3").find("expected RADIUS,DISTANCE"), std::string::npos);
  EXPECT_NE(problem("--lens -1,3").find("expected RADIUS,DISTANCE"), std::string::npos);
  EXPECT_NE(problem("--lens 1,nan").find("expected RADIUS,DISTANCE"), std::string::npos);
  EXPECT_NE(problem("--shutter 1,0").find("expected OPEN,CLOSE"), std::string::npos);
  EXPECT_NE(problem("--gloss 0:1").find("NUMBER:RADIUS"), std::string::npos);
  EXPECT_NE(problem("--gloss x").find("NUMBER:RADIUS"), std::string::npos);
  EXPECT_NE(problem("--gloss 9:0.1").find("--gloss names number 9, but the number of surfaces is 2"),
            std::string::npos);
  EXPECT_NE(problem("--disk-radius 2:0.1").find("--disk-radius names number 2, but the number of lights is 1"),
            std::string::npos);
  EXPECT_NE(problem("--without fog").find("there is no effect `fog`"), std::string::npos);
  EXPECT_NE(problem("--exposure 0.3").find("whole number of halves"), std::string::npos);
}

}  // namespace
}  // namespace penumbra
