// `penumbra render --noise` as users call it: what it writes, reports and refuses.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/render/render_command.hpp"
#include "base/command_line.hpp"
#include "base/test_folder.hpp"
#include "image/image_file.hpp"

namespace penumbra {
namespace {

class NoiseOption : public testing::Test {
 protected:
  NoiseOption() {
    std::ofstream(scene_) << "image_size 20 20\nrays_per_pixel 2\nbackground 0.1 0.1 0.1\n"
                             "diffuse 0 0 0 1 1 1\nsphere 1 0.1 0.2 -4\n";
  }

  // The exit code; what was printed is in `printed_`.
  int render(const std::vector<std::string>& arguments) {
    const RenderOptions options =
        test::parse_command(render_subcommand, test::command_line({"render", scene_}, arguments));
    testing::internal::CaptureStderr();
    const int exit_code = render_command(options);
    printed_ = testing::internal::GetCapturedStderr();
    return exit_code;
  }

  test::TestFolder folder_;
  std::string scene_ = folder_ / "scene.cli", picture_ = folder_ / "out.exr", stats_ = folder_ / "stats.json";
  std::string printed_;
};

TEST_F(NoiseOption, WritesWhereTheRaysWent) {
  ASSERT_EQ(render({"--noise", "0.02", "--aov", "samples,variance", "-o", picture_, "--stats", stats_}), 0);
  EXPECT_NE(printed_.find("rays per pixel on average"), std::string::npos) << printed_;
  EXPECT_EQ(printed_.find("more noise"), std::string::npos) << printed_;
  const ImageFile file = read_image(picture_);
  double total = 0;
  for (const Channel& layer : file.layers) {
    if (layer.name != "samples.Y") continue;
    for (const float samples : layer.values) total += samples;
  }
  const nlohmann::json stats = nlohmann::json::parse(std::ifstream(stats_));
  EXPECT_EQ(stats["samples"].get<double>(), total);
  EXPECT_EQ(stats["noise"].get<double>(), 0.02);
  EXPECT_NE(std::find(file.metadata.begin(), file.metadata.end(), std::pair<std::string, std::string>("noise", "0.02")),
            file.metadata.end());
}

TEST_F(NoiseOption, SaysThatTheMostRaysWereNotEnough) {
  ASSERT_EQ(render({"--noise", "0.0001", "--rays", "32", "-o", picture_}), 0);
  EXPECT_NE(printed_.find("of 400 pixels got the maximum of 32 rays"), std::string::npos) << printed_;
  ASSERT_EQ(render({"--noise", "0.0001", "--rays", "32", "-o", picture_, "--quiet"}), 0);
  EXPECT_EQ(printed_, "");
}

TEST_F(NoiseOption, RefusesWhatIsNoGood) {
  for (const char* error : {"0", "-1", "nan", "inf", "2", "1e-9", "some", ""}) {
    EXPECT_THROW(render({"--noise", error, "-o", picture_}), test::WrongUse) << error;
  }
  EXPECT_THROW(render({"--noise", "0.1", "--rays", "3", "-o", picture_}), test::WrongUse);
}

// Dots that cover a hundredth of a pixel: the first round has to be told to look closely.
TEST_F(NoiseOption, FindsSmallObjectsWithMoreFirstRays) {
  std::ofstream dots(scene_);
  dots << "image_size 64 64\ndiffuse 0 0 0 5 5 5\n";
  for (int y = -7; y <= 7; y++) {
    for (int x = -7; x <= 7; x++) dots << "sphere 0.004 " << x * 0.29 + 0.01 << ' ' << y * 0.29 + 0.02 << " -4\n";
  }
  dots.close();
  ASSERT_EQ(render({"--rays", "16384", "-o", picture_}), 0);
  const auto mean = [this] {
    const ImageFile file = read_image(picture_);
    const auto& rgb = file.image.rgb;
    return std::accumulate(rgb.begin(), rgb.end(), 0.0) / static_cast<double>(rgb.size());
  };
  const double truth = mean();
  ASSERT_EQ(render({"--noise", "0.02", "-o", picture_}), 0);
  EXPECT_NE(printed_.find("may miss 225 small objects, and --noise then sends no more there: --first-rays 512"),
            std::string::npos)
      << printed_;
  EXPECT_LT(mean(), 0.7 * truth);
  ASSERT_EQ(render({"--noise", "0.02", "--first-rays", "512", "-o", picture_}), 0);
  EXPECT_EQ(printed_.find("small object"), std::string::npos) << printed_;
  EXPECT_NEAR(mean(), truth, 0.05 * truth);
  ASSERT_EQ(render({"--noise", "0.1", "-o", picture_}), 0);
  EXPECT_EQ(printed_.find("small object"), std::string::npos) << "such dots do not matter there: " << printed_;
}

// Patterns with a fixed number of rays cannot be extended.
TEST_F(NoiseOption, RefusesPatternsThatNeedACount) {
  for (std::size_t i = 0; i < std::size(pattern_names); i++) {
    const int code = render({"--noise", "0.1", "--sampler", std::string(pattern_names[i]), "-o", picture_});
    EXPECT_EQ(code, needs_count(static_cast<Pattern>(i)) ? 64 : 0) << pattern_names[i];
  }
}

}  // namespace
}  // namespace penumbra
