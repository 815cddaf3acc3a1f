// The default pattern against independent random points, 64 rays per pixel, mean of five seeds: at most a quarter of
// the variance on soft shadow, gloss, motion and lens each alone (the scenes A, C, D and B of the peers' folder, if it
// exists), and at most 1/2.5 on all effects at once (the demo scene).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/test_scale.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

Scene scene_of_file(const std::filesystem::path& path) {
  const SceneFile file = read_scene(path, {});
  for (const Action& action : file.actions) {
    if (const auto* picture = std::get_if<Picture>(&action)) return *picture->scene;
  }
  ADD_FAILURE() << "no picture in " << path;
  return {};
}

ZeroedVector<float> colors(Scene scene, Pattern pattern, int rays, std::uint32_t seed) {
  scene.settings.rays_per_pixel = rays;
  scene.settings.seed = seed;
  RenderSettings settings;
  settings.pattern = pattern;
  return render_scene(scene, settings).color;
}

// The mean squared difference from the converged picture, over pixels, channels and five seeds.
double variance(const Scene& scene, Pattern pattern, const ZeroedVector<float>& converged) {
  double sum = 0;
  for (std::uint32_t seed = 0; seed < 5; seed++) {
    const ZeroedVector<float> color = colors(scene, pattern, 64, seed);
    for (std::size_t i = 0; i < color.size(); i++) {
      const double difference = double{color[i]} - double{converged[i]};
      sum += difference * difference;
    }
  }
  return sum / (5.0 * static_cast<double>(converged.size()));
}

double ratio_to_random(const std::filesystem::path& path, int width, int height) {
  Scene scene = scene_of_file(path);
  scene.settings.width = width;
  scene.settings.height = height;
  const ZeroedVector<float> converged = colors(scene, Pattern::sobol, 2048, 1000);
  return variance(scene, Pattern::sobol, converged) / variance(scene, Pattern::random, converged);
}

TEST(Variance, OfAllEffectsTogether) {
  if (slow_build) GTEST_SKIP() << "takes minutes without optimisation";
  EXPECT_LE(ratio_to_random(PENUMBRA_SCENES "/demo.cli", 60, 45), 1 / 2.5);
}

class VarianceOfOneEffect : public testing::TestWithParam<const char*> {};

TEST_P(VarianceOfOneEffect, IsAQuarter) {
  if (slow_build) GTEST_SKIP() << "takes minutes without optimisation";
  const char* named = std::getenv("PENUMBRA_PEERS_DIR");
  const std::filesystem::path folder = named ? named : PENUMBRA_DEFAULT_PEERS_DIR;
  const std::filesystem::path scene = folder / GetParam();
  if (!std::filesystem::exists(scene)) GTEST_SKIP() << "there is no " << scene;
  EXPECT_LE(ratio_to_random(scene, 100, 100), 1 / 4.0);
}

INSTANTIATE_TEST_SUITE_P(Peers, VarianceOfOneEffect, testing::Values("A.cli", "B.cli", "C.cli", "D.cli"),
                         [](const auto& p) { return std::string(1, p.param[0]); });

}  // namespace
}  // namespace penumbra::test
