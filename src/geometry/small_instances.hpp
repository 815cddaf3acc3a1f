// Which instances are taken apart. To carry rays into the space of an instance costs as much as several shapes, so an
// instance of few shapes is replaced by these shapes, each under the product of the matrices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace penumbra {

class SmallInstances {
 public:
  SmallInstances(const Scene& scene, std::uint32_t embree_threshold);

  // Whether an instance of the definition is taken apart in a group that has so many instances. What it holds is then
  // taken apart, too. A moving one is taken apart only if it is very small: the bounds of its shapes over the shutter
  // overlap where those of the whole would not.
  bool takes_apart(std::uint32_t definition, std::size_t instances_in_group, bool moves) const;

 private:
  // How many shapes and triangles each definition stands for; `never` if something in it needs a space of its own, such
  // as a texture, vertex normals or a mesh for Embree.
  std::vector<double> sizes_;
};

// How many instances there are among the objects and in groups among them.
std::size_t count_instances(std::span<const Object> objects);

}  // namespace penumbra
