// The subcommand as the user sees it: options, table, JSON, heat map and exit codes.
#include "app/compare/compare_command.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/command_line.hpp"
#include "base/test_folder.hpp"
#include "image/image_file.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

struct CommandResult {
  int exit_code;
  std::string out, err;
};

// Parses and runs as `penumbra compare ARGUMENTS` does.
CommandResult run(const std::vector<std::string>& arguments) {
  const CompareOptions options = test::parse_command(compare_subcommand, test::command_line({"compare"}, arguments));
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exit_code = compare_command(options);
  std::fflush(stdout);
  const std::string out = testing::internal::GetCapturedStdout(), err = testing::internal::GetCapturedStderr();
  return {exit_code, out, err};
}

class CompareCommand : public testing::Test {
 protected:
  CompareCommand() {
    write_image(a_, whole_picture(test::pattern(40, 30)));
    write_image(b_, whole_picture(test::pattern(40, 30, 20)));
  }

  test::TestFolder folder_;
  std::string a_ = folder_ / "a.png", b_ = folder_ / "b.png";
};

TEST_F(CompareCommand, TheSamePicture) {
  const CommandResult result = run({a_, a_});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, "A                       " + a_ + "\nB                       " + a_ +
                            "\n"
                            "size                    40 x 30\n"
                            "mean absolute error     0\n"
                            "RMSE                    0\n"
                            "PSNR                    inf\n"
                            "SSIM                    1\n"
                            "FLIP                    0\n"
                            "largest difference      0\n"
                            "pixels beyond 1e-06     0 of 1200 (0 %)\n"
                            "result                  same\n");
}

TEST_F(CompareCommand, AnotherPicture) {
  const CommandResult result = run({a_, b_, "--failpercent", "60", "--hardwarn", "0.5"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("pixels beyond 1e-06     480 of 1200 (40 %)\n"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("result                  warning\n"), std::string::npos) << result.out;
  EXPECT_EQ(run({a_, b_}).exit_code, 2);
  EXPECT_EQ(run({a_, b_, "--fail", "1", "--warn", "1"}).exit_code, 0);
}

TEST_F(CompareCommand, Json) {
  const nlohmann::json json = nlohmann::json::parse(run({a_, b_, "--json", "--fail", "0.5"}).out);
  const Comparison expected = compare(read_image(a_), read_image(b_), {.fail = 0.5});
  EXPECT_EQ(json["a"], a_);
  EXPECT_EQ(json["b"], b_);
  EXPECT_EQ(json["width"], 40);
  EXPECT_EQ(json["height"], 30);
  EXPECT_EQ(json["mean_absolute_error"], expected.errors.mean_absolute_error);
  EXPECT_EQ(json["rmse"], expected.errors.rmse);
  EXPECT_EQ(json["psnr"], expected.errors.psnr);
  EXPECT_EQ(json["ssim"], expected.ssim);
  EXPECT_EQ(json["flip"], expected.flip);
  EXPECT_EQ(json["max_difference"], expected.max_difference);
  EXPECT_EQ(json["threshold"], 0.5);
  EXPECT_EQ(json["pixels_beyond"], expected.pixels_beyond);
  EXPECT_GT(expected.pixels_beyond, 0u);
  EXPECT_EQ(json["percent_beyond"], static_cast<double>(expected.pixels_beyond) / 12);
  EXPECT_EQ(json["result"], "failed");
  EXPECT_TRUE(nlohmann::json::parse(run({a_, a_, "--json"}).out)["psnr"].is_null());
}

TEST_F(CompareCommand, PixelsThatAreNotFiniteAreTold) {
  Image a = test::flat(40, 30, 0, 0, 0), b = a;
  a.rgb[0] = NAN;
  b.rgb[0] = b.rgb[30] = b.rgb[31] = INFINITY;
  const std::string file_a = folder_ / "a.exr", file_b = folder_ / "b.exr";
  write_image(file_a, whole_picture(a));
  write_image(file_b, whole_picture(b));
  const CommandResult table = run({file_a, file_b});
  EXPECT_EQ(table.exit_code, 2);
  EXPECT_NE(table.out.find("mean absolute error     inf\nRMSE                    inf\n"), std::string::npos)
      << table.out;
  EXPECT_NE(table.out.find("pixels not finite       A 1, B 2\n"), std::string::npos) << table.out;
  const nlohmann::json json = nlohmann::json::parse(run({file_a, file_a, "--json"}).out);
  EXPECT_EQ(json["pixels_not_finite"]["a"], 1);
  EXPECT_EQ(json["pixels_not_finite"]["b"], 1);
  EXPECT_EQ(json["result"], "same");
}

TEST_F(CompareCommand, LayersAreNamed) {
  ImageFile file = test::crop_with_layers();
  write_image(folder_ / "a.exr", file);
  file.layers[0].values[5] = 77;
  file.layers.pop_back();
  write_image(folder_ / "b.exr", file);
  const CommandResult table = run({folder_ / "a.exr", folder_ / "b.exr"});
  EXPECT_EQ(table.exit_code, 2);
  EXPECT_NE(table.out.find("layer depth.Z           largest difference "), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("layer samples           in one file only\n"), std::string::npos) << table.out;
  const nlohmann::json json = nlohmann::json::parse(run({folder_ / "a.exr", folder_ / "b.exr", "--json"}).out);
  EXPECT_EQ(json["layers"]["depth.Z"]["pixels_beyond"], 1);
  EXPECT_EQ(json["layers"]["normal.X"]["pixels_beyond"], 0);
  EXPECT_EQ(json["missing_layers"], nlohmann::json({"samples"}));
}

TEST_F(CompareCommand, TheHeatMapIsWritten) {
  const std::string heat = folder_ / "heat.png";
  EXPECT_EQ(run({a_, b_, "--heatmap", heat}).exit_code, 2);
  const ImageFile map = read_image(heat);
  EXPECT_EQ(map.image.width, 40);
  EXPECT_EQ(map.image.rgb[0] + map.image.rgb[1] + map.image.rgb[2], 0);  // the first stripe is the same in both
  EXPECT_GT(map.image.rgb[3 * 9], 0);
  const CommandResult bad = run({a_, b_, "--heatmap", folder_ / "none/heat.png"});
  EXPECT_EQ(bad.exit_code, 73);
  EXPECT_NE(bad.err.find("penumbra compare: cannot create `"), std::string::npos) << bad.err;
  EXPECT_EQ(run({a_, b_, "--heatmap", folder_ / "heat.jpg"}).exit_code, 73);
}

TEST_F(CompareCommand, DifferentSizes) {
  const std::string other = folder_ / "other.png";
  write_image(other, whole_picture(test::pattern(40, 31)));
  const CommandResult result = run({a_, other});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "penumbra compare: the pictures differ in size: `" + a_ + "` has 40 x 30 pixels, `" + other +
                            "` has 40 x 31 pixels\n");
  EXPECT_EQ(nlohmann::json::parse(run({a_, other, "--json"}).out)["result"], "different size");
}

TEST_F(CompareCommand, TheSameSizeSomewhereElse) {
  ImageFile file = test::crop_with_layers();
  write_image(folder_ / "a.exr", file);
  file.window = {6, 7, 19, 16};
  write_image(folder_ / "b.exr", file);
  const CommandResult result = run({folder_ / "a.exr", folder_ / "b.exr"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("13 x 9 pixels from (5, 7) of 40 x 30"), std::string::npos) << result.err;
}

TEST_F(CompareCommand, MissingAndDamagedFiles) {
  const std::string none = folder_ / "none.png", bad = folder_ / "bad.png";
  test::put_content(bad, test::content_of(a_).substr(0, 100));
  const CommandResult result = run({a_, none});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err, "penumbra compare: cannot open `" + none + "`: No such file or directory\n");
  EXPECT_EQ(run({bad, a_}).exit_code, 4);
  EXPECT_EQ(nlohmann::json::parse(run({a_, none, "--json"}).out)["result"], "no such file");
}

TEST(CompareOptionsTest, WrongUseIsRefused) {
  const auto parse = [](const std::vector<std::string>& arguments) {
    test::parse_command(compare_subcommand, test::command_line({"compare"}, arguments));
  };
  EXPECT_NO_THROW(parse({"a", "b"}));
  EXPECT_NO_THROW(parse({"a", "b", "--hardfail", "inf"}));
  EXPECT_THROW(parse({"a"}), test::WrongUse);
  EXPECT_THROW(parse({"a", "b", "--fail", "-1"}), test::WrongUse);
  EXPECT_THROW(parse({"a", "b", "--fail", "nan"}), test::WrongUse);
  EXPECT_THROW(parse({"a", "b", "--fail", "x"}), test::WrongUse);
  EXPECT_THROW(parse({"a", "b", "c"}), test::WrongUse);
}

}  // namespace
}  // namespace penumbra
