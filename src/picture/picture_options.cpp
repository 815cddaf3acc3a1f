#include "picture/picture_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <span>
#include <tuple>

#include "rendering/adaptive.hpp"

namespace penumbra {
namespace {

void set_radii(std::vector<Surface>& surfaces, const std::vector<NumberedRadius>& radii, double Surface::*share,
               double Surface::*radius) {
  for (const NumberedRadius& wanted : radii) {
    for (std::size_t i = 0; i < surfaces.size(); i++) {
      const bool meant = wanted.number == 0 || static_cast<std::size_t>(wanted.number) == i + 1;
      if (meant && surfaces[i].*share != 0) surfaces[i].*radius = wanted.radius;
    }
  }
}

void set_disk_radii(std::vector<Light>& lights, const std::vector<NumberedRadius>& radii) {
  for (const NumberedRadius& wanted : radii) {
    for (std::size_t i = 0; i < lights.size(); i++) {
      auto* disk = std::get_if<DiskLight>(&lights[i]);
      const bool meant = wanted.number == 0 || static_cast<std::size_t>(wanted.number) == i + 1;
      if (disk && meant) disk->radius = wanted.radius;
    }
  }
}

void leave_out(Scene& scene, Effects effects) {
  Camera& camera = scene.camera;
  if (effects.has(Effect::lens)) camera.lens_radius = 0;
  if (effects.has(Effect::motion)) camera.shutter_close = camera.shutter_open;
  const std::vector<NumberedRadius> none = {{0, 0.0}};
  if (effects.has(Effect::disk_lights)) set_disk_radii(scene.lights, none);
  if (effects.has(Effect::gloss)) set_radii(scene.surfaces, none, &Surface::reflection, &Surface::gloss_radius);
  if (effects.has(Effect::translucency)) {
    set_radii(scene.surfaces, none, &Surface::transmission, &Surface::blur_radius);
  }
}

std::string beyond(std::span<const NumberedRadius> radii, std::size_t count, const char* option, const char* things) {
  for (const NumberedRadius& radius : radii) {
    if (static_cast<std::size_t>(radius.number) <= count) continue;
    return fmt::format("{} names number {} of {} {}", option, radius.number, count, things);
  }
  return {};
}

}  // namespace

double exposure_factor(int halves) {
  const int whole = (halves - (halves & 1)) / 2;
  return std::ldexp(halves & 1 ? std::numbers::sqrt2 : 1.0, whole);
}

std::string missing_number(const Scene& scene, const PictureOptions& options) {
  const std::size_t surfaces = scene.surfaces.size();
  if (auto text = beyond(options.gloss, surfaces, "--gloss", "surfaces"); !text.empty()) return text;
  if (auto text = beyond(options.blur, surfaces, "--blur", "surfaces"); !text.empty()) return text;
  return beyond(options.disk_radius, scene.lights.size(), "--disk-radius", "lights");
}

Scene with_options(Scene scene, const PictureOptions& options) {
  if (options.noise) scene.rays_per_pixel = static_cast<int>(NoiseGoal().most_rays);  // the scene's own is no limit
  if (options.rays) scene.rays_per_pixel = *options.rays;
  if (options.size) std::tie(scene.width, scene.height) = *options.size;
  if (options.max_depth) scene.max_depth = *options.max_depth;
  if (options.reflection_rays) scene.reflection_rays = *options.reflection_rays;
  if (options.transmission_rays) scene.transmission_rays = *options.transmission_rays;
  if (options.shadow_rays) scene.shadow_rays = *options.shadow_rays;
  if (options.seed) scene.seed = *options.seed;
  if (options.lens) {
    std::tie(scene.camera.lens_radius, scene.camera.focus_distance) = *options.lens;
    scene.camera.focal_length = scene.camera.f_number = 0;
  }
  if (options.shutter) std::tie(scene.camera.shutter_open, scene.camera.shutter_close) = *options.shutter;
  if (options.time) scene.camera.shutter_open = scene.camera.shutter_close = *options.time;
  if (options.frame) {
    scene.camera.shutter_open = options.frame->time_at(scene.camera.shutter_open);
    scene.camera.shutter_close = options.frame->time_at(scene.camera.shutter_close);
  }
  set_radii(scene.surfaces, options.gloss, &Surface::reflection, &Surface::gloss_radius);
  set_radii(scene.surfaces, options.blur, &Surface::transmission, &Surface::blur_radius);
  set_disk_radii(scene.lights, options.disk_radius);
  leave_out(scene, options.without);
  return scene;
}

Pattern pattern_for(const Scene& scene, const PictureOptions& options) {
  if (options.sampler) return *options.sampler;
  if (options.course) return Pattern::random;
  return pattern_from_name(scene.sampler).value_or(default_pattern);
}

TracingOptions tracing_options(const Scene& scene, const PictureOptions& options) {
  TracingOptions tracing;
  tracing.pattern = pattern_for(scene, options);
  tracing.seed = scene.seed;
  tracing.max_depth = scene.max_depth;
  tracing.rays_per_pixel = scene.rays_per_pixel;
  tracing.reflection_rays = scene.reflection_rays;
  tracing.transmission_rays = scene.transmission_rays;
  tracing.shadow_rays = scene.shadow_rays;
  tracing.regular_lights = options.regular_lights;
  tracing.course = options.course;
  tracing.antialiasing = !options.without.has(Effect::antialiasing);
  tracing.shadows = !options.no_shadows;
  tracing.transparent_shadows = options.transparent_shadows;
  tracing.lens_model = options.lens_model;
  return tracing;
}

}  // namespace penumbra
