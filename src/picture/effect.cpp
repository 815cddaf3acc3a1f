#include "picture/effect.hpp"

namespace penumbra {
namespace {

// Calls `set(index, radius)` for everything that a radius applies to.
template <class Set>
void for_each_meant(const std::vector<NumberedRadius>& radii, std::size_t count, const Set& set) {
  for (const NumberedRadius& wanted : radii) {
    for (std::size_t i = 0; i < count; i++) {
      if (wanted.number == 0 || static_cast<std::size_t>(wanted.number) == i + 1) set(i, wanted.radius);
    }
  }
}

void set_radii(std::vector<Surface>& surfaces, const std::vector<NumberedRadius>& radii, double Surface::*share,
               double Surface::*radius) {
  for_each_meant(radii, surfaces.size(), [&](std::size_t i, double wanted) {
    if (surfaces[i].*share != 0) surfaces[i].*radius = wanted;
  });
}

}  // namespace

std::string to_string(Effects effects) {
  std::string text;
  for (int i = 0; i < effect_count; i++) {
    if (!effects.has(static_cast<Effect>(i))) continue;
    if (!text.empty()) text += ',';
    text += effect_names[i];
  }
  return text;
}

void set_gloss(Scene& scene, const std::vector<NumberedRadius>& radii) {
  set_radii(scene.surfaces, radii, &Surface::reflection, &Surface::gloss_radius);
}

void set_blur(Scene& scene, const std::vector<NumberedRadius>& radii) {
  set_radii(scene.surfaces, radii, &Surface::transmission, &Surface::blur_radius);
}

void set_disk_radius(Scene& scene, const std::vector<NumberedRadius>& radii) {
  for_each_meant(radii, scene.lights.size(), [&](std::size_t i, double wanted) {
    if (auto* disk = std::get_if<DiskLight>(&scene.lights[i])) disk->radius = wanted;
  });
}

void leave_out(Scene& scene, Effects effects) {
  Camera& camera = scene.camera;
  const std::vector<NumberedRadius> none = {{0, 0.0}};
  if (effects.has(Effect::antialiasing)) scene.settings.antialiasing = false;
  if (effects.has(Effect::lens)) camera.lens_radius = 0;
  if (effects.has(Effect::motion)) camera.shutter_close = camera.shutter_open;
  if (effects.has(Effect::disk_lights)) {
    for (Light& light : scene.lights) light = std::visit([](const auto& l) { return without_area(l); }, light);
  }
  if (effects.has(Effect::gloss)) set_gloss(scene, none);
  if (effects.has(Effect::translucency)) set_blur(scene, none);
}

}  // namespace penumbra
