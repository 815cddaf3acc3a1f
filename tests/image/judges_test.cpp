// Independent judges: OpenImageIO's oiiotool must read our files as we meant them, and idiff must find the same figures
// and give the same exit codes. Skipped where the tools are not installed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/compare/compare_command.hpp"
#include "base/test_folder.hpp"
#include "image/image_file.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

using test::run_program;
using test::TestFolder;

class Judges : public testing::Test {
 protected:
  void SetUp() override {
    static const bool have_tools = test::have_program("idiff") && test::have_program("oiiotool");
    if (!have_tools) GTEST_SKIP() << "openimageio-tools is not installed";
  }

  std::string file(const std::string& name) const { return folder_ / name; }

  TestFolder folder_;
};

// The number after `label` in another program's output.
double number_after(const std::string& text, const std::string& label) {
  const std::size_t at = text.find(label);
  return at == text.npos ? NAN : std::atof(text.c_str() + at + label.size());
}

TEST_F(Judges, OurFilesAreReadAsWeMeantThem) {
  write_image(file("a.png"), whole_picture(test::pattern(61, 43)));
  write_image(file("deep.png"), whole_picture(test::pattern(61, 43)), {16, Rounding::nearest});
  write_image(file("a.exr"), whole_picture(test::pattern(61, 43)));
  EXPECT_EQ(run_program("idiff " + file("a.png") + " " + file("a.exr")).exit_code, 0);
  EXPECT_EQ(run_program("idiff " + file("deep.png") + " " + file("a.exr")).exit_code, 0);
}

TEST_F(Judges, TheirFilesAreReadAsTheyMeantThem) {
  const Image image = test::pattern(61, 43);
  write_image(file("a.exr"), whole_picture(image));
  const std::string tool = "oiiotool " + file("a.exr") + " ";
  ASSERT_EQ(run_program(tool + "-d uint8 -o " + file("their.png")).exit_code, 0);
  ASSERT_EQ(run_program(tool + "-d uint16 -o " + file("deep.png")).exit_code, 0);
  ASSERT_EQ(run_program(tool + "--compression piz -d float -o " + file("piz.exr")).exit_code, 0);
  ASSERT_EQ(run_program(tool + "--tile 16 16 -d float -o " + file("tiles.exr")).exit_code, 0);
  for (const char* name : {"their.png", "deep.png", "piz.exr", "tiles.exr"}) {
    EXPECT_EQ(read_image(file(name)).image, image) << name;
  }
}

TEST_F(Judges, WindowsLayersAndMetadataAreWhereOthersLookForThem) {
  write_image(file("a.exr"), test::crop_with_layers());
  const std::string info = run_program("oiiotool --info -v " + file("a.exr")).output;
  for (const char* expected :
       {"13 x    9, 7 channel, float openexr", "channel list: R, G, B, samples, depth.Z, normal.X, normal.Y",
        "pixel data origin: x=5, y=7", "full/display size: 40 x 30", "full/display origin: 0, 0",
        "compression: \"zip\"", "penumbra:options: \"--rays 16 --seed 3\"", "penumbra:version: \"0.1.0\""}) {
    EXPECT_NE(info.find(expected), info.npos) << expected << "\nin\n" << info;
  }
  write_image(file("a.png"), test::crop_with_layers());
  const std::string png_info = run_program("oiiotool --info -v " + file("a.png")).output;
  EXPECT_NE(png_info.find("13 x    9, 3 channel, uint8 png"), png_info.npos) << png_info;
  EXPECT_NE(png_info.find("penumbra:options: \"--rays 16 --seed 3\""), png_info.npos) << png_info;
}

TEST_F(Judges, IdiffFindsTheSameFigures) {
  for (const int shift : {1, 3, 20, 100}) {
    for (const char* ending : {".png", ".exr"}) {
      Image image = test::pattern(64, 48), other = test::pattern(64, 48, shift);
      if (ending[1] == 'e') image.rgb[100] = 7.5f;  // brighter than white
      const std::string a = file(std::string("a") + ending), b = file(std::string("b") + ending);
      write_image(a, whole_picture(image));
      write_image(b, whole_picture(other));
      const Comparison ours = compare(read_image(a), read_image(b), {});
      const std::string theirs = run_program(fmt::format("idiff -v {} {}", a, b)).output;
      EXPECT_NEAR(ours.errors.mean_absolute_error / number_after(theirs, "Mean error = "), 1, 1e-5) << theirs;
      EXPECT_NEAR(ours.errors.rmse / number_after(theirs, "RMS error = "), 1, 1e-5) << theirs;
      EXPECT_NEAR(ours.errors.psnr, number_after(theirs, "Peak SNR = "), 1e-3) << theirs;
      EXPECT_NEAR(ours.max_difference / number_after(theirs, "Max error  = "), 1, 1e-5) << theirs;
      const std::string count = "  " + std::to_string(ours.pixels_beyond) + " pixels (";
      EXPECT_NE(theirs.find(count), theirs.npos) << count << "\nin\n" << theirs;
    }
  }
}

// A case that idiff 2.4 judges by its manual: some pixel is beyond `fail`, or none is beyond any threshold. (If no
// pixel is beyond `fail`, it checks neither `hardfail` nor the warnings, because its newer option -allowfailures, 0 by
// default, is then already satisfied.)
struct IdiffCase {
  const char* theirs;
  Thresholds ours;
  int exit_code;
};

TEST_F(Judges, IdiffGivesTheSameExitCodes) {
  const Image image = test::flat(10, 10, 0.5f, 0.5f, 0.5f);
  Image other = image;
  other.rgb[0] = other.rgb[3] = 0.75f;  // two pixels by 0.25
  other.rgb[5] = 0.625f;                // one of them also by 0.125
  write_image(file("a.exr"), whole_picture(image));
  write_image(file("b.exr"), whole_picture(other));
  const double inf = std::numeric_limits<double>::infinity();
  const IdiffCase cases[] = {
      {"", {}, 2},
      {"-fail 0.3 -warn 0.3", {0.3, 0, inf, 0.3, 0, inf}, 0},
      {"-fail 0.25 -warn 0.25", {0.25, 0, inf, 0.25, 0, inf}, 0},
      {"-fail 0.2 -warn 0.3", {0.2, 0, inf, 0.3, 0, inf}, 2},
      {"-fail 0.2 -failpercent 2 -warn 0.3", {0.2, 2, inf, 0.3, 0, inf}, 0},
      {"-fail 0.2 -failpercent 1.9 -warn 0.3", {0.2, 1.9, inf, 0.3, 0, inf}, 2},
      {"-fail 0.2 -failpercent 5 -warn 0.1", {0.2, 5, inf, 0.1, 0, inf}, 1},
      {"-fail 0.2 -failpercent 5 -warn 0.1 -warnpercent 2", {0.2, 5, inf, 0.1, 2, inf}, 0},
      {"-fail 0.2 -failpercent 5 -warnpercent 5 -hardfail 0.24", {0.2, 5, 0.24, 1e-6, 5, inf}, 2},
      {"-fail 0.2 -failpercent 5 -warnpercent 5 -hardwarn 0.24", {0.2, 5, inf, 1e-6, 5, 0.24}, 1},
      {"-fail 0.2 -failpercent 5 -warnpercent 5 -hardwarn 0.25 -hardfail 0.25", {0.2, 5, 0.25, 1e-6, 5, 0.25}, 0},
  };
  for (const IdiffCase& one : cases) {
    const std::string command = std::string("idiff ") + one.theirs + " " + file("a.exr") + " " + file("b.exr");
    EXPECT_EQ(run_program(command).exit_code, one.exit_code) << command;
    const Comparison ours = compare(read_image(file("a.exr")), read_image(file("b.exr")), one.ours);
    EXPECT_EQ(static_cast<int>(ours.verdict), one.exit_code) << command;
  }
  EXPECT_EQ(run_program("idiff " + file("a.exr") + " " + file("a.exr")).exit_code, 0);
  EXPECT_EQ(run_program("idiff " + file("a.exr") + " " + file("none.exr")).exit_code, 4);
}

}  // namespace
}  // namespace penumbra
