// Pairs whose pictures are means of random samples: the 9x9 box mean of the difference, and the noise of the picture
// compared with our own, both against the pair's tolerance. The limits in index.json are well above the difference
// between two of our own renders, and the seeds are fixed: a correct renderer that passes once always passes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/test_scale.hpp"
#include "reference/pair.hpp"

namespace penumbra::test {
namespace {

using Plane = std::vector<double>;  // three numbers per pixel of the crop

Plane plane_of(const Levels& levels, const std::vector<int>& crop) {
  Plane plane;
  for (int y = crop[1]; y < crop[3]; y++) {
    for (int x = crop[0]; x < crop[2]; x++) {
      for (int c = 0; c < 3; c++) plane.push_back(levels.at(x, y, c));
    }
  }
  return plane;
}

Plane difference(const Plane& a, const Plane& b) {
  Plane result(a.size());
  for (std::size_t i = 0; i < a.size(); i++) result[i] = a[i] - b[i];
  return result;
}

double standard_deviation(const Plane& a) {
  double sum = 0, squares = 0;
  for (const double v : a) {
    sum += v;
    squares += v * v;
  }
  const auto n = static_cast<double>(a.size());
  return std::sqrt(squares / n - sum / n * (sum / n));
}

struct Windows {
  double rms = 0, largest = 0;
};

// Means over all 9x9 windows that are fully inside.
Windows windows_of(const Plane& plane, int width, int height) {
  constexpr int size = 9;
  const std::size_t row = 3 * static_cast<std::size_t>(width + 1);
  std::vector<double> sums(row * static_cast<std::size_t>(height + 1));
  const auto at = [&](int x, int y, int c) -> double& {
    return sums[static_cast<std::size_t>(y) * row + static_cast<std::size_t>(3 * x + c)];
  };
  Windows windows;
  double squares = 0, count = 0;
  for (int y = 1; y <= height; y++) {
    for (int x = 1; x <= width; x++) {
      for (int c = 0; c < 3; c++) {
        const auto pixel = static_cast<std::size_t>(3 * ((y - 1) * width + x - 1) + c);
        at(x, y, c) = plane[pixel] + at(x - 1, y, c) + at(x, y - 1, c) - at(x - 1, y - 1, c);
        if (x < size || y < size) continue;
        const double mean =
            (at(x, y, c) - at(x - size, y, c) - at(x, y - size, c) + at(x - size, y - size, c)) / (size * size);
        windows.largest = std::max(windows.largest, std::abs(mean));
        squares += mean * mean;
        count++;
      }
    }
  }
  windows.rms = std::sqrt(squares / count);
  return windows;
}

class StochasticPair : public testing::TestWithParam<const char*> {};

TEST_P(StochasticPair, IsReproduced) {
  const auto folder = reference_folder();
  if (!folder) GTEST_SKIP() << "no folder of published pictures; name one with PENUMBRA_REFERENCE_DIR";
  const std::string name = GetParam();
  const nlohmann::json entry = reference_entry(*folder, name);
  if (entry.is_null()) GTEST_SKIP() << "this folder has no pair " << name;
  const int rays = entry.at("rays_per_pixel");
  if (slow_build && rays > 1) GTEST_SKIP() << "too many rays for a build with checks";

  const std::filesystem::path scene = *folder / name / "scene.cli";
  const std::vector<int> crop = entry.at("crop");
  const Plane reference = plane_of(read_levels(*folder / name / "reference.png"), crop);
  const Plane own = plane_of(render_levels(scene, "--seed 2 --threads 2"), crop);
  ASSERT_EQ(own.size(), reference.size());

  // The mean of many samples. With one ray per pixel, its place in the pixel is fixed: then it is the mean of many
  // pictures. Otherwise 200 independent samples, as for the limits: the noise that is left in them is part of both
  // deviations.
  Plane converged(own.size());
  const int pictures = rays > 1 ? 1 : scaled(64, 8);
  for (int i = 0; i < pictures; i++) {
    const std::string more = rays > 1 ? " --rays 200" : "";
    const Plane picture = plane_of(render_levels(scene, "--threads 2 --seed " + std::to_string(100 + i) + more), crop);
    ASSERT_EQ(picture.size(), own.size());
    for (std::size_t k = 0; k < picture.size(); k++) converged[k] += picture[k] / pictures;
  }

  const nlohmann::json& tolerance = entry.at("tolerance");
  const int width = crop[2] - crop[0], height = crop[3] - crop[1];
  const Windows windows = windows_of(difference(own, reference), width, height);
  EXPECT_LE(windows.rms, tolerance.at("window_rms").get<double>());
  EXPECT_LE(windows.largest, tolerance.at("window_max").get<double>());
  const double ratio =
      standard_deviation(difference(reference, converged)) / standard_deviation(difference(own, converged));
  EXPECT_GE(ratio, tolerance.at("pixel_std_ratio")[0].get<double>());
  EXPECT_LE(ratio, tolerance.at("pixel_std_ratio")[1].get<double>());
  const nlohmann::json& tighter = tolerance.at("high_spp_render");
  const Windows mean_windows = windows_of(difference(converged, reference), width, height);
  EXPECT_LE(mean_windows.rms, tighter.at("window_rms").get<double>());
  EXPECT_LE(mean_windows.largest, tighter.at("window_max").get<double>());
}

constexpr const char* names[] = {"12-2-sphere-50spp",     "13-2-motion-blur-1spp",   "14-2-motion-blur-100spp",
                                 "15-2-soft-shadow-1spp", "16-2-soft-shadow-100spp", "17-2-lens-1spp",
                                 "18-2-lens-100spp-f3",   "19-2-lens-100spp-f6"};

std::string test_name(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Reference, StochasticPair, testing::ValuesIn(names), test_name);

}  // namespace
}  // namespace penumbra::test
