// Triangles find their room: long static runs go to Embree, the rest become leaves of our own hierarchy.
#pragma once

#include <vector>

#include "geometry/embree_mesh.hpp"
#include "geometry/group_leaves.hpp"

namespace penumbra {

// Triangles of one object, with the place of the first in the order of the group.
struct TriangleRun {
  TriangleRange range;
  std::uint32_t order;
  std::uint32_t surface;
};

class TriangleLeaves {
 public:
  TriangleLeaves(World& world, const Scene& scene, const WorldOptions& options)
      : world_(world), scene_(scene), options_(options), device_(options.threads) {}

  // Adds a run that moves as one.
  void add_moving(GroupLeaves& group, const TriangleRun& run, Vec3 motion);

  // Adds a run of flat triangles under a map to the space of the group.
  void add_placed(GroupLeaves& group, const TriangleRun& run, const Affine& group_from_run, Vec3 motion);

  // Adds static runs, in the order of the group. Small ones that follow each other are joined first. A long run is an
  // Embree scene of its own: at equal distance Embree's rounding would decide inside one scene, we do between two.
  void add_static(GroupLeaves& group, const std::vector<TriangleRun>& runs);

 private:
  void add_mesh(GroupLeaves& group, const std::vector<TriangleRun>& runs, Vec3 motion);
  void add_singly(GroupLeaves& group, const TriangleRun& run, Vec3 motion);
  // `corners` has the three corners of a triangle in the space of the group, by its number in the run.
  template <typename Corners>
  void add_each(GroupLeaves& group, const TriangleRun& run, const Corners& corners, Vec3 motion);

  World& world_;
  const Scene& scene_;
  const WorldOptions& options_;
  EmbreeDevice device_;
};

}  // namespace penumbra
