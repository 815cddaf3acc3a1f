#include "picture/scene_lines.hpp"

#include <gtest/gtest.h>

#include "rendering/render_text.hpp"

namespace penumbra {
namespace {

const std::string scene_text = R"(rays_per_pixel 4
camera_lens 0.5 2 8
disk_light 0 5 0 0.5 0 -1 0 1 1 1
point_light 1 1 1 1 1 1
glossy 0.1 0.2 0.3 0.4 0.5 0.6 20 0.7 0.1
noise 4
sphere 1 0 0 -5
shiny 1 1 1 0.1 0.1 0.1 1 1 1 10 0.5 0 1
sphere 1 3 0 -5
)";

std::string lines(const PictureOptions& options) { return changed_lines(test::scene_from(scene_text), options); }

TEST(SceneLines, NothingChangedIsNothingSaid) {
  EXPECT_EQ(lines({}), "");
  PictureOptions options;
  options.rays = 4;
  options.sampler = default_pattern;
  options.gloss = {{1, 0.1}};
  EXPECT_EQ(lines(options), "") << "the same numbers as in the scene";
}

TEST(SceneLines, WholePicture) {
  PictureOptions options;
  options.rays = 64;
  options.size = {320, 200};
  options.sampler = Pattern::jittered;
  options.seed = 9;
  options.max_depth = 3;
  options.shadow_rays = 5;
  EXPECT_EQ(lines(options),
            "image_size 320 200\nrays_per_pixel 64\nsampler jittered\nseed 9\nmax_depth 3\nshadow_rays 5\n");
}

TEST(SceneLines, CameraLightsAndSurfaces) {
  PictureOptions options;
  options.lens = {0.125, 6.1};
  options.without.add(Effect::motion);
  options.disk_radius = {{0, 0.25}};
  options.gloss = {{1, 0.3}};
  EXPECT_EQ(lines(options),
            "shutter 0 0\nlens 0.125 6.1\ndisk_light 0 5 0 0.25 0 -1 0 1 1 1\n"
            "glossy 0.1 0.2 0.3 0.4 0.5 0.6 20 0.7 0.3\nnoise 4\n");
}

TEST(SceneLines, LightsWithoutTheirAreas) {
  PictureOptions options;
  options.without.add(Effect::disk_lights);
  const Scene scene = test::scene_from(scene_text + "quad_light 1 5 2 0.5 0 0 0 0 1 0.1 0.2 0.3\n");
  EXPECT_EQ(changed_lines(scene, options), "disk_light 0 5 0 0 0 -1 0 1 1 1\npoint_light 1 5 2 0.1 0.2 0.3\n");
}

TEST(SceneLines, WhatHasNoCommandIsAComment) {
  PictureOptions options;
  options.gloss = {{2, 0.3}};
  options.without.add(Effect::antialiasing);
  EXPECT_EQ(lines(options),
            "# surface 2: gloss radius 0.3, blur radius 0; there is no command for them\n"
            "# --without antialiasing: there is no command for it\n");
}

}  // namespace
}  // namespace penumbra
