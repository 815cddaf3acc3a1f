#include "rendering/small_objects.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "geometry/object_bounds.hpp"

namespace penumbra {
namespace {

// As many rays are expected to hit an object that is found: all of them miss it in one case of fifty or fewer.
constexpr double hits_expected = 4;

// An upper bound of what a surface shows without reflections.
double brightness(const Surface& surface, double light) {
  return max_component(surface.ambient) + light * (max_component(surface.diffuse) + max_component(surface.specular));
}

}  // namespace

SmallObjects small_objects(const Scene& scene, double error, std::uint32_t rays) {
  const Camera& camera = scene.camera;
  const Settings& settings = scene.settings;
  const double half_view = std::tan(camera.fov_degrees * std::numbers::pi / 360);
  const double shorter = std::min(settings.width, settings.height);
  const Vec3 right = normalize(camera.right), up = normalize(camera.up), view = -normalize(camera.back);
  double light = 0, brightest = 0;
  for (const Light& l : scene.lights) light += std::visit([](const auto& x) { return max_component(x.color); }, l);
  for (const Surface& surface : scene.surfaces) brightest = std::max(brightest, brightness(surface, light));
  SmallObjects found;
  ObjectBounds bounds_of(scene, camera.shutter_open);
  for_each_object(scene.root.objects, bounds_of, [&](const Object& object, const Bounds& bounds) {
    const Vec3 to_center = (bounds.lo + bounds.hi) / 2 - camera.eye;
    const double distance = dot(to_center, view);
    const double pixel = 2 * half_view * distance / shorter;
    if (is_empty(bounds) || !(pixel > 0) || std::abs(dot(to_center, right)) > pixel * settings.width / 2 ||
        std::abs(dot(to_center, up)) > pixel * settings.height / 2) {
      return;
    }
    const Vec3 size = bounds.hi - bounds.lo;
    const double longest = max_component(size), shortest = -max_component(-size);
    const double covered =
        std::numbers::pi / 4 * longest * (size.x + size.y + size.z - longest - shortest) / (pixel * pixel);
    const bool is_instance = std::holds_alternative<Instance>(object.shape);
    const double bright = is_instance ? brightest : brightness(scene.surfaces[object.surface], light);
    if (longest >= pixel || covered * bright <= error || covered * rays >= hits_expected) return;
    found.count++;
    found.rays =
        std::max(found.rays, std::bit_ceil(static_cast<std::uint32_t>(std::min(hits_expected / covered, 1e9))));
  });
  return found;
}

}  // namespace penumbra
