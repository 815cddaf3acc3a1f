// All kinds of pictures that can be rendered in several sessions, and the films they must give, to the bit.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/test_scale.hpp"
#include "rendering/all_effects.hpp"
#include "rendering/checkpoint.hpp"
#include "rendering/film_values.hpp"
#include "rendering/render_adaptive.hpp"
#include "rendering/render_text.hpp"
#include "rendering/uniform_render.hpp"

namespace penumbra::test {

struct PictureOfTest {
  std::string name;
  std::string text;
  std::optional<float> noise;
  PixelRect crop{0, 0, 53, 37};
  Layers layers = all_layers;
};

inline std::ostream& operator<<(std::ostream& out, const PictureOfTest& picture) { return out << picture.name; }

inline std::vector<PictureOfTest> pictures_of_test() {
  const std::string few = scene_text(scaled(40, 20)), many = scene_text(scaled(256, 64));
  const PixelRect crop{5, 7, 39, 30};
  return {{"uniform", few, {}},
          {"uniform, one ray", scene_text(1), {}},
          {"uniform, crop, colour only", few, {}, crop, {}},
          {"uniform, Embree", scene_text(20) + mesh_text(), {}},
          {"uniform, many rays from a hit", scene_text(3) + "reflection_rays 900\nmax_depth 1\n", {}, {20, 10, 40, 30}},
          {"adaptive", many, 0.03f},
          {"adaptive, crop", many, 0.03f, crop},
          {"adaptive, colour only", many, 0.05f, {0, 0, 53, 37}, {}},
          {"adaptive, Embree", scene_text(64) + mesh_text(), 0.05f}};
}

// A picture ready to be rendered.
struct Setting {
  explicit Setting(const PictureOfTest& picture)
      : plan{picture.crop, picture.layers, 1}, scene(scene_from(picture.text)), frame(frame_from(scene)) {
    if (picture.noise) goal = NoiseGoal{*picture.noise, static_cast<std::uint32_t>(scene.settings.rays_per_pixel)};
    key.version = "1";
    key.plan = {{"name", picture.name}};
  }

  std::unique_ptr<ResumableRender> render(const Kernel& kernel) const {
    if (goal) return std::make_unique<AdaptiveRender>(frame, kernel, plan, *goal);
    return std::make_unique<UniformRender>(frame, kernel, plan,
                                           static_cast<std::uint32_t>(scene.settings.rays_per_pixel), true);
  }

  Plan plan;
  Scene scene;
  Frame frame;
  std::optional<NoiseGoal> goal;
  PictureKey key;
};

// The film of one unbroken render, by the plain loops.
inline FilmValues unbroken(const Setting& setting) {
  RenderState state;
  const Kernel& kernel = *usable_kernels().back();
  const auto rays = static_cast<std::uint32_t>(setting.scene.settings.rays_per_pixel);
  Film film(setting.plan.crop, setting.plan.layers, setting.goal ? SampleCounts::per_pixel : SampleCounts::uniform);
  if (setting.goal) {
    render_adaptive(film, setting.frame, kernel, setting.plan, *setting.goal, state);
  } else {
    render_samples(film, setting.frame, kernel, setting.plan, {0, rays}, state);
  }
  return values_of(film);
}

}  // namespace penumbra::test
