#include "geometry/small_instances.hpp"

#include <limits>

namespace penumbra {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double most_of_group = 65'536;  // shapes that the instances of a group may become
constexpr double most_of_moving = 4;

struct Measure {
  const Scene& scene;
  std::uint32_t embree_threshold;
  const std::vector<double>& sizes;  // of the definitions so far: a definition names only those before it

  double of(std::span<const Object> objects) const {
    double sum = 0;
    for (const Object& object : objects) {
      sum += std::visit([&](const auto& shape) { return of_shape(object, shape); }, object.shape);
    }
    return sum;
  }

 private:
  bool has_texture(const Object& object) const { return scene.surfaces[object.surface].texture != Texture::none; }
  double of_shape(const Object&, const std::shared_ptr<const Group>& group) const { return of(group->objects); }
  double of_shape(const Object&, const Instance& instance) const { return sizes[instance.definition]; }
  double of_shape(const Object& object, const TriangleRange& range) const {
    const bool stays = has_texture(object) || range.normals != TriangleRange::flat || range.count >= embree_threshold;
    return stays ? never : range.count;
  }
  template <AnalyticShape Shape>
  double of_shape(const Object& object, const Shape&) const {
    return has_texture(object) ? never : 1;
  }
};

}  // namespace

SmallInstances::SmallInstances(const Scene& scene, std::uint32_t embree_threshold) {
  for (const Object& definition : scene.definitions) {
    sizes_.push_back(Measure{scene, embree_threshold, sizes_}.of({&definition, 1}));
  }
}

bool SmallInstances::takes_apart(std::uint32_t definition, std::size_t instances_in_group, bool moves) const {
  const double size = sizes_[definition];
  return moves ? size <= most_of_moving : size * static_cast<double>(instances_in_group) <= most_of_group;
}

std::size_t count_instances(std::span<const Object> objects) {
  std::size_t count = 0;
  for (const Object& object : objects) {
    if (std::holds_alternative<Instance>(object.shape)) count++;
    if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape)) {
      count += count_instances((*group)->objects);
    }
  }
  return count;
}

}  // namespace penumbra
