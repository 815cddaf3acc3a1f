// The bounds of the objects of a scene, before a world is built of them.
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/leaf.hpp"

namespace penumbra {

// The bounding boxes of objects at one time, in the space of the group that holds them. The box of a definition is
// computed once; instances transform that box.
class ObjectBounds {
 public:
  ObjectBounds(const Scene& scene, double time) : scene_(scene), time_(time), definitions_(scene.definitions.size()) {}

  Bounds of(const Object& object) {
    const Affine& placement = scene_.placements[object.placement];
    const Bounds at_time_0 = std::visit([&](const auto& shape) { return of_shape(shape, placement); }, object.shape);
    return is_empty(at_time_0) ? at_time_0 : shift(at_time_0, object.motion * time_);
  }

 private:
  template <AnalyticShape Shape>
  Bounds of_shape(const Shape& shape, const Affine& placement) {
    return transformed_bounds(placement, shape);
  }
  Bounds of_shape(const TriangleRange& range, const Affine&) { return bounds_of(*scene_.triangles, range); }
  Bounds of_shape(const std::shared_ptr<const Group>& group, const Affine&) {
    Bounds bounds;
    for (const Object& member : group->objects) bounds = include(bounds, of(member));
    return bounds;
  }
  Bounds of_shape(const Instance& instance, const Affine& placement) {
    std::optional<Bounds>& definition = definitions_[instance.definition];
    if (!definition) definition = of(scene_.definitions[instance.definition]);
    return transform(placement, *definition);
  }

  const Scene& scene_;
  double time_;
  std::vector<std::optional<Bounds>> definitions_;
};

// Calls `visit(object, bounds)` for all objects of some groups that lie in one space, taking nested groups apart; for
// their triangles together, which may be those of a fine mesh, with the last of them.
template <class Visit>
void for_each_object(const Objects& objects, ObjectBounds& bounds_of, const Visit& visit) {
  Bounds triangles;
  const Object* last = nullptr;
  const auto look_at = [&](const auto& self, const Objects& members) -> void {
    for (const Object& object : members) {
      if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape)) {
        self(self, (*group)->objects);
      } else if (std::holds_alternative<TriangleRange>(object.shape)) {
        triangles = include(triangles, bounds_of.of(object));
        last = &object;
      } else {
        visit(object, bounds_of.of(object));
      }
    }
  };
  look_at(look_at, objects);
  if (last) visit(*last, triangles);
}

}  // namespace penumbra
