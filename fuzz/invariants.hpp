// Invariants of every scene that is read without an error. A fuzzer stops where one does not hold.
#pragma once

#include <cmath>
#include <cstdlib>
#include <variant>

#include "geometry/leaf.hpp"
#include "scene/scene.hpp"

namespace penumbra {

inline void require(bool condition) {
  if (!condition) std::abort();
}

inline void require_sound(const TriangleStore& store) {
  require(store.vertices.size() % 3 == 0 && store.indices.size() % 3 == 0);
  for (const float value : store.vertices) require(std::isfinite(value));
  for (const std::uint32_t index : store.indices) require(index < store.vertices.size() / 3);
  require(store.normals.size() % 3 == 0 && store.normal_numbers.size() % 3 == 0);
  for (const float value : store.normals) require(std::abs(value) <= 1);
  for (const std::uint32_t number : store.normal_numbers) require(number <= store.normals.size() / 3);
}

template <AnalyticShape Shape>
void require_sound(const Shape& shape) {
  const Bounds bounds = bounds_of(shape);
  require(is_finite(bounds.lo) && is_finite(bounds.hi) && min(bounds.lo, bounds.hi) == bounds.lo);
  if constexpr (requires { shape.radius; }) require(shape.radius > 0);
}

// The object may name the first `definitions` definitions: in definition k those before it, so none contains itself.
inline void require_sound(const Scene& scene, const Object& object, std::size_t definitions) {
  require(object.placement < scene.placements.size());
  require(is_finite(object.motion));
  if (const auto* range = std::get_if<TriangleRange>(&object.shape)) {
    require(range->count > 0);
    require(std::size_t{range->first} + range->count <= scene.triangles->triangle_count());
    require(range->normals == TriangleRange::flat ||
            3 * (std::size_t{range->normals} + range->count) <= scene.triangles->normal_numbers.size());
  } else if (const auto* instance = std::get_if<Instance>(&object.shape)) {
    require(instance->definition < definitions);
    return;
  } else if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape)) {
    require(*group != nullptr);
    for (const Object& inner : (*group)->objects) require_sound(scene, inner, definitions);
    return;
  } else {
    const auto check = []<typename Kind>(const Kind& shape) {
      if constexpr (AnalyticShape<Kind>) require_sound(shape);
    };
    std::visit(check, object.shape);
  }
  require(object.surface < scene.surfaces.size());
}

inline void require_sound(const Scene& scene) {
  require(scene.triangles != nullptr);
  require_sound(*scene.triangles);
  require(scene.settings.width > 0 && scene.settings.height > 0 && scene.settings.rays_per_pixel > 0 &&
          scene.settings.max_depth >= 0);
  require(scene.camera.fov_degrees > 0 && scene.camera.fov_degrees < 180);
  require(scene.camera.shutter_open <= scene.camera.shutter_close && scene.camera.focus_distance > 0);
  for (const Affine& placement : scene.placements) require(is_finite(inverse(placement).translation));
  for (std::size_t k = 0; k < scene.definitions.size(); k++) require_sound(scene, scene.definitions[k], k);
  for (const Object& object : scene.root.objects) require_sound(scene, object, scene.definitions.size());
}

}  // namespace penumbra
