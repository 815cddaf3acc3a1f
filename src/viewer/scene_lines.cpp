#include "viewer/scene_lines.hpp"

#include <fmt/format.h>

namespace penumbra {
namespace {

std::string words(Vec3 v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

std::string surface_line(const Surface& s) {
  const std::string colors = words(s.diffuse) + ' ' + words(s.specular);
  if (s.transmission != 0) {
    return fmt::format("translucent {} {} {} {} {} {} {}\n", colors, s.specular_power, s.reflection, s.gloss_radius,
                       s.transmission, s.refraction_index, s.blur_radius);
  }
  return fmt::format("glossy {} {} {} {}\n", colors, s.specular_power, s.reflection, s.gloss_radius);
}

std::string texture_line(const Surface& s) {
  switch (s.texture) {
    case Texture::none:
      return {};
    case Texture::noise:
      return fmt::format("noise {}\n", s.texture_scale);
    case Texture::wood:
      return "wood\n";
    case Texture::marble:
      return "marble\n";
    case Texture::stone:
      return "stone\n";
  }
  return {};
}

// `glossy` and `translucent` know neither ambient light nor Phong's highlight.
bool has_command(const Surface& s) {
  return s.highlight == Highlight::blinn && s.ambient.x == 0 && s.ambient.y == 0 && s.ambient.z == 0;
}

std::string changed_surfaces(const Scene& before, const Scene& after) {
  std::string text;
  for (std::size_t i = 0; i < after.surfaces.size(); i++) {
    const Surface& s = after.surfaces[i];
    if (s == before.surfaces[i]) continue;
    if (has_command(s)) {
      text += surface_line(s) + texture_line(s);
    } else {
      text += fmt::format("# surface {}: gloss radius {}, blur radius {}; it has no command for them\n", i + 1,
                          s.gloss_radius, s.blur_radius);
    }
  }
  return text;
}

std::string changed_lights(const Scene& before, const Scene& after) {
  std::string text;
  for (std::size_t i = 0; i < after.lights.size(); i++) {
    const auto* now = std::get_if<DiskLight>(&after.lights[i]);
    const auto* then = std::get_if<DiskLight>(&before.lights[i]);
    if (!now || !then || now->radius == then->radius) continue;
    text += fmt::format("disk_light {} {} {} {}\n", words(now->center), now->radius, words(now->direction),
                        words(now->color));
  }
  return text;
}

}  // namespace

std::string changed_lines(const Scene& scene, const PictureOptions& options) {
  const Scene after = with_options(scene, options);
  const auto line = [](bool changed, std::string text) { return changed ? std::move(text) : std::string(); };
  const Camera& a = after.camera;
  const Camera& b = scene.camera;
  std::string text;
  text += line(after.width != scene.width || after.height != scene.height,
               fmt::format("image_size {} {}\n", after.width, after.height));
  text += line(after.rays_per_pixel != scene.rays_per_pixel, fmt::format("rays_per_pixel {}\n", after.rays_per_pixel));
  text += line(a.lens_radius != b.lens_radius || a.focus_distance != b.focus_distance,
               fmt::format("lens {} {}\n", a.lens_radius, a.focus_distance));
  text += line(a.shutter_open != b.shutter_open || a.shutter_close != b.shutter_close,
               fmt::format("shutter {} {}\n", a.shutter_open, a.shutter_close));
  const Pattern pattern = pattern_for(after, options);
  text +=
      line(pattern != pattern_for(scene, {}), fmt::format("sampler {}\n", pattern_names[static_cast<int>(pattern)]));
  text += line(after.seed != scene.seed, fmt::format("seed {}\n", after.seed));
  text += line(after.max_depth != scene.max_depth, fmt::format("max_depth {}\n", after.max_depth));
  text +=
      line(after.reflection_rays != scene.reflection_rays, fmt::format("reflection_rays {}\n", after.reflection_rays));
  text += line(after.transmission_rays != scene.transmission_rays,
               fmt::format("transmission_rays {}\n", after.transmission_rays));
  text += line(after.shadow_rays != scene.shadow_rays, fmt::format("shadow_rays {}\n", after.shadow_rays));
  text += changed_lights(scene, after);
  text += changed_surfaces(scene, after);
  text += line(options.without.has(Effect::antialiasing), "# without antialiasing: there is no command for it\n");
  return text;
}

}  // namespace penumbra
