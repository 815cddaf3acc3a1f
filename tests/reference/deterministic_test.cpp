// Pairs whose pictures use no random numbers: the percentage of pixels whose largest channel difference is at most one
// or two 8-bit levels, and the mean difference, inside the crop and the mask, against the pair's tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "reference/pair.hpp"

namespace penumbra::test {
namespace {

struct Agreement {
  double percent_le1 = 0, percent_le2 = 0, mean_abs = 0;
};

Agreement compare_levels(const Levels& a, const Levels& b, const std::vector<int>& crop, const Levels* mask) {
  double pixels = 0, le1 = 0, le2 = 0, sum = 0;
  for (int y = crop[1]; y < crop[3]; y++) {
    for (int x = crop[0]; x < crop[2]; x++) {
      if (mask && mask->at(x, y, 0) != 255) continue;
      int largest = 0;
      for (int c = 0; c < 3; c++) {
        const int difference = std::abs(a.at(x, y, c) - b.at(x, y, c));
        largest = std::max(largest, difference);
        sum += difference;
      }
      pixels++;
      le1 += largest <= 1;
      le2 += largest <= 2;
    }
  }
  return {100 * le1 / pixels, 100 * le2 / pixels, sum / (3 * pixels)};
}

// Does to our picture what the screen of that pair did to its own, which was drawn through a matrix that shrank it
// about the centre, with four subsamples per pixel. Row j of the formula's picture is our row j; its extra row 300 is
// needed only below the crop, so a picture of the ordinary size is enough.
Levels resample(const Levels& picture, const nlohmann::json& recipe, const std::vector<int>& crop) {
  const double scale = recipe.at("scale");
  const double center_x = recipe.at("centre")[0], center_y = recipe.at("centre")[1];
  Levels result = picture;
  for (int y = crop[1]; y < crop[3]; y++) {
    for (int x = crop[0]; x < crop[2]; x++) {
      for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (const nlohmann::json& sub : recipe.at("subsamples")) {
          const int column = static_cast<int>(std::floor((x + sub[0].get<double>() - center_x) / scale + center_x));
          const int row = static_cast<int>(std::floor((y + sub[1].get<double>() - center_y) / scale + center_y));
          EXPECT_TRUE(column >= 0 && column < picture.width && row >= 0 && row < picture.height);
          sum += picture.at(column, row, c);
        }
        result.values[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(result.width) +
                           static_cast<std::size_t>(x)) +
                      static_cast<std::size_t>(c)] =
            static_cast<int>(std::lround(sum / static_cast<double>(recipe.at("subsamples").size())));
      }
    }
  }
  return result;
}

class DeterministicPair : public testing::TestWithParam<const char*> {};

TEST_P(DeterministicPair, IsReproduced) {
  const auto folder = reference_folder();
  if (!folder) GTEST_SKIP() << "no folder of published pictures; name one with PENUMBRA_REFERENCE_DIR";
  const std::string name = GetParam();
  const nlohmann::json entry = reference_entry(*folder, name);
  if (entry.is_null()) GTEST_SKIP() << "this folder has no pair " << name;

  const Levels reference = read_levels(*folder / name / "reference.png");
  std::string options =
      "--size " + std::to_string(reference.width) + "x" + std::to_string(reference.height) + " --threads 1";
  // The first steps of the course had no shadows yet.
  if (name < "04") options += " --no-shadows";
  Levels picture = render_levels(*folder / name / "scene.cli", options);
  ASSERT_EQ(picture.width, reference.width);
  ASSERT_EQ(picture.height, reference.height);

  const std::vector<int> crop = entry.at("crop");
  if (entry.contains("resample")) picture = resample(picture, entry.at("resample"), crop);
  std::optional<Levels> mask;
  if (entry.contains("mask")) mask = read_levels(*folder / name / "mask.png");
  const Agreement agreement = compare_levels(picture, reference, crop, mask ? &*mask : nullptr);

  const nlohmann::json& tolerance = entry.at("tolerance");
  EXPECT_GE(agreement.percent_le1, tolerance.at("percent_le1").get<double>());
  EXPECT_GE(agreement.percent_le2, tolerance.value("percent_le2", 0.0));
  EXPECT_LE(agreement.mean_abs, tolerance.value("mean_abs", 255.0));
  RecordProperty("percent_le1", std::to_string(agreement.percent_le1));
  RecordProperty("mean_abs", std::to_string(agreement.mean_abs));
}

// The names are listed here rather than read from index.json, so that the tests have the same names on every machine.
constexpr const char* names[] = {"00-rect-test",
                                 "01-1a-red-sphere",
                                 "02-1a-two-spheres-no-shadow",
                                 "03-1a-three-coloured-lights",
                                 "04-1b-two-spheres-shadow",
                                 "05-1b-triangle",
                                 "06-1b-triangle-translated",
                                 "07-1b-icosahedron",
                                 "08-1b-cube",
                                 "09-1b-four-boxes",
                                 "10-1b-sphere-rings",
                                 "11-2-sphere-1spp",
                                 "20-3-instances",
                                 "21-3-instance-scaled-sphere",
                                 "22-3-instances-scaled-spheres",
                                 "23-3-box",
                                 "24-3-four-boxes",
                                 "25-3-four-boxes-list",
                                 "26-3-bunny-list",
                                 "27-3-bunny-accel",
                                 "28-4-noise",
                                 "29-4-wood",
                                 "30-4-marble",
                                 "31-4-stone",
                                 "32-5-green-sphere",
                                 "33-5-three-spheres-shadow",
                                 "34-5-phong-highlight",
                                 "35-5-triangle",
                                 "36-5-icosahedron",
                                 "37-5-sphere-in-icosahedron",
                                 "38-5-reflective-sphere",
                                 "39-5-five-mirrors"};

std::string test_name(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Reference, DeterministicPair, testing::ValuesIn(names), test_name);

}  // namespace
}  // namespace penumbra::test
