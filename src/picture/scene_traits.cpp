#include "picture/scene_traits.hpp"

#include <algorithm>

namespace penumbra {
namespace {

template <class Test>
bool any_surface(const Scene& scene, const Test& test) {
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), test);
}

bool any_moves(const Objects& objects) {
  return std::any_of(objects.begin(), objects.end(), [](const Object& object) {
    const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape);
    return object.motion != Vec3{} || (group != nullptr && any_moves((*group)->objects));
  });
}

}  // namespace

bool reflects(const Scene& scene) {
  return any_surface(scene, [](const Surface& s) { return s.reflection != 0; });
}
bool transmits(const Scene& scene) {
  return any_surface(scene, [](const Surface& s) { return s.transmission != 0; });
}
bool is_glossy(const Scene& scene) {
  return any_surface(scene, [](const Surface& s) { return s.reflection != 0 && s.gloss_radius > 0; });
}
bool is_translucent(const Scene& scene) {
  return any_surface(scene, [](const Surface& s) { return s.transmission != 0 && s.blur_radius > 0; });
}

bool has_area_light(const Scene& scene) { return std::any_of(scene.lights.begin(), scene.lights.end(), has_area); }

bool has_lens(const Scene& scene) { return scene.camera.lens_radius > 0; }

bool has_motion(const Scene& scene) { return any_moves(scene.root.objects) || any_moves(scene.definitions); }

bool moves(const Scene& scene) { return scene.camera.shutter_open != scene.camera.shutter_close && has_motion(scene); }

bool is_random(const Scene& scene) {
  return scene.settings.rays_per_pixel > 1 || has_lens(scene) || moves(scene) || has_area_light(scene) ||
         is_glossy(scene) || is_translucent(scene);
}

}  // namespace penumbra
