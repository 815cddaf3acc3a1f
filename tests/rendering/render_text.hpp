// From a scene as text to pixels, through the same steps as the program.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "language/scene_file.hpp"
#include "rendering/isa.hpp"
#include "rendering/uniform_render.hpp"

namespace penumbra::test {

struct RenderSettings {
  Course course = Course::off;
  bool shadows = true;
  bool transparent_shadows = false;
  bool regular_lights = false;
  LensModel lens_model = LensModel::thin;
  Pattern pattern = default_pattern;
  Layers layers = {};
  int threads = 2;
  const Kernel* kernel = nullptr;  // the widest
  std::optional<PixelRect> crop = {};
};

// The only picture of the text, which must have no errors.
inline Scene scene_from(const std::string& text, const RenderSettings& settings = {}) {
  const SceneFile file = read_scene_text(text, "test.cli", {settings.course, false});
  for (const Diagnostic& d : file.diagnostics) {
    EXPECT_NE(d.severity, Severity::error) << to_string(d);
  }
  for (const Action& action : file.actions) {
    if (const auto* picture = std::get_if<Picture>(&action)) return *picture->scene;
  }
  ADD_FAILURE() << "no picture";
  return {};
}

inline Frame frame_from(const Scene& scene, const RenderSettings& settings = {}) {
  Scene set = scene;
  set.settings.pattern = settings.pattern;
  set.settings.regular_lights = settings.regular_lights;
  set.settings.course = settings.course;
  set.settings.shadows = settings.shadows;
  set.settings.transparent_shadows = settings.transparent_shadows;
  set.settings.lens_model = settings.lens_model;
  return make_frame(set, settings.threads);
}

// A finished film, and its means pixel by pixel.
struct Picture3 {
  Film film;
  RayCounts rays;
  ZeroedVector<float> color;

  explicit Picture3(Film f, RayCounts r) : film(std::move(f)), rays(r), color(film.color()) {}

  // In coordinates of the full picture.
  Vec3 at(int x, int y) const { return value(color, x, y); }
  Vec3 value(const ZeroedVector<float>& means, int x, int y) const {
    const PixelRect& c = film.crop();
    const auto i = 3 * static_cast<std::size_t>((y - c.y0) * c.width() + (x - c.x0));
    return {means[i], means[i + 1], means[i + 2]};
  }
  Vec3 mean() const {
    Vec3 sum;
    for (std::size_t i = 0; i < color.size(); i += 3) sum = sum + Vec3{color[i], color[i + 1], color[i + 2]};
    return sum / (static_cast<double>(color.size()) / 3);
  }
};

inline Picture3 render_scene(const Scene& scene, const RenderSettings& settings = {}) {
  const Frame frame = frame_from(scene, settings);
  Plan plan;
  plan.crop = settings.crop.value_or(PixelRect{0, 0, scene.settings.width, scene.settings.height});
  plan.layers = settings.layers;
  plan.threads = settings.threads;
  Film film(plan.crop, plan.layers);
  RenderState state;
  const Kernel& kernel = settings.kernel ? *settings.kernel : *usable_kernels().back();
  const RayCounts rays =
      render_samples(film, frame, kernel, plan, {0, static_cast<std::uint32_t>(scene.settings.rays_per_pixel)}, state);
  return Picture3(std::move(film), rays);
}

inline Picture3 render_text(const std::string& text, const RenderSettings& settings = {}) {
  return render_scene(scene_from(text, settings), settings);
}

}  // namespace penumbra::test
