#include "viewer/error_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rendering/render_text.hpp"
#include "viewer/growing_picture.hpp"

namespace penumbra {
namespace {

TEST(ErrorEstimate, SaysNothingBeforeThereIsSomethingToCompare) {
  ErrorEstimate estimate;
  EXPECT_FALSE(estimate.error());
  estimate.add(2, std::vector<float>(30, 0.5f), false);
  EXPECT_FALSE(estimate.error());
  estimate.add(4, std::vector<float>(30, 0.5f), false);
  EXPECT_EQ(estimate.error(), 0.0);
}

const std::string soft_shadow = R"(image_size 48 48
background 0.2 0.2 0.3
disk_light 2 5 -2 1.5 0 -1 0 1 1 1
diffuse 0.8 0.7 0.6 0.1 0.1 0.1
sphere 1 0 0 -5
sphere 50 0 -51 -5
)";

struct Errors {
  double estimated, real;
};

// Rendered with another seed and many more rays.
const ZeroedVector<float>& true_picture() {
  static const ZeroedVector<float> picture = [] {
    Scene scene = test::scene_from(soft_shadow);
    scene.settings.rays_per_pixel = 4096;
    scene.settings.seed = 77;
    return test::render_scene(scene).color;
  }();
  return picture;
}

// The estimated and the real error after a number of rays.
Errors errors_with_seed(std::uint32_t seed, std::uint32_t rays, Pattern pattern) {
  LoadedScene loaded;
  loaded.scene = std::make_shared<const Scene>(test::scene_from(soft_shadow));
  const ZeroedVector<float>& truth = true_picture();

  PictureOptions options;
  options.sampler = pattern;
  options.seed = seed;
  BuiltWorld world;
  GrowingPicture picture(loaded, options, world, 1);
  RenderState state;
  PassRules rules{.needs_count = picture.needs_count(), .limit = rays};
  std::uint32_t done = 0;
  while (const auto pass = next_pass(rules, done, 0)) {
    picture.prepare(*pass);
    EXPECT_TRUE(picture.draw(*usable_kernels().back(), 1, state));
    picture.keep();
    done = pass->end;
  }
  const RefinedSide side = picture.side();
  double sum = 0;
  for (std::size_t i = 0; i < truth.size(); i++) sum += std::pow(side.image.rgb[i] - truth[i], 2);
  return {side.error.value_or(-1), std::sqrt(sum / static_cast<double>(truth.size()))};
}

// Over several seeds, as the estimate of one alone scatters.
Errors errors_after(std::uint32_t rays, Pattern pattern) {
  constexpr std::uint32_t seeds = 4;
  Errors squares{0, 0};
  for (std::uint32_t seed = 0; seed < seeds; seed++) {
    const Errors one = errors_with_seed(seed, rays, pattern);
    squares.estimated += one.estimated * one.estimated / seeds;
    squares.real += one.real * one.real / seeds;
  }
  return {std::sqrt(squares.estimated), std::sqrt(squares.real)};
}

TEST(ErrorEstimate, IsNearTheTruth) {
  for (const Pattern pattern : {Pattern::random, Pattern::sobol, Pattern::halton, Pattern::bluenoise}) {
    for (const std::uint32_t rays : {16u, 24u, 64u, 256u}) {
      const auto [estimated, real] = errors_after(rays, pattern);
      EXPECT_GT(estimated, 0.6 * real) << pattern_names[static_cast<int>(pattern)] << " with " << rays;
      EXPECT_LT(estimated, 1.7 * real) << pattern_names[static_cast<int>(pattern)] << " with " << rays;
    }
  }
}

TEST(ErrorEstimate, OfSetsDrawnAnewIsNoLessThanTheTruth) {
  for (const Pattern pattern : {Pattern::jittered, Pattern::multijittered, Pattern::poisson}) {
    const auto [estimated, real] = errors_after(64, pattern);
    EXPECT_GT(estimated, 0.8 * real) << pattern_names[static_cast<int>(pattern)];
    EXPECT_LT(estimated, 4 * real) << pattern_names[static_cast<int>(pattern)];
  }
}

}  // namespace
}  // namespace penumbra
