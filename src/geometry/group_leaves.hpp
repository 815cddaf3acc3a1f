// The leaves of one group while a world is built: what is common to all kinds.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/bvh_item.hpp"
#include "geometry/world.hpp"

namespace penumbra {

// The error of a hit whose surface the numbers of a shape do not give exactly, as a share of its largest coordinate.
inline constexpr double slack_share = 1.0 / (1 << 21);

// What testing a leaf costs, in tests of a sphere.
inline constexpr std::uint32_t shape_cost = 1, placed_cost = 2, instance_cost = 8, mesh_cost = 16;

// Triangles do not tell whether they enclose a solid; what does not refract is a sheet.
inline Passage passage_of(const Surface& surface, bool triangle) {
  if (surface.transmission == 0) return Passage::opaque;
  return triangle && surface.refraction_index == 1 ? Passage::sheet : Passage::solid;
}

// Where a leaf is: its bounds at time 0, its shift per unit of time, and the largest coordinate met on the way to a
// hit, if that is larger than those of the bounds.
struct LeafExtent {
  Bounds bounds;
  Vec3 motion;
  double reach = 0;
};

struct GroupLeaves {
  ZeroedVector<Leaf> leaves;
  ZeroedVector<BvhItem> items;  // the bounds of each
  Vec3 origin;                  // WorldGroup::origin
  std::uint32_t order = 0;
  double magnitude = 0;                // largest coordinate, in absolute value, on the way to a hit point
  std::vector<std::uint32_t> normals;  // as World::leaf_normals; those missing at the end are flat

  // Makes room for so many leaves; returns the index of the first.
  std::size_t make_room(std::size_t count) {
    const std::size_t first = leaves.size();
    leaves.resize(first + count);
    items.resize(first + count);
    return first;
  }

  // Sets what the leaf at an index has from its extent, and its bounds; returns the largest coordinate on the way to
  // its hits.
  double finish(std::size_t index, const LeafExtent& extent, std::uint32_t cost, const WorldOptions& options);

  // Adds a leaf whose order is known.
  void add(const Leaf& leaf, const LeafExtent& extent, std::uint32_t cost, const WorldOptions& options) {
    const std::size_t index = make_room(1);
    leaves[index] = leaf;
    magnitude = std::max(magnitude, finish(index, extent, cost, options));
  }
};

// Appends the placement of an affine map to those of the world, and returns its index.
std::uint32_t add_placement(World& world, const Affine& m);

}  // namespace penumbra
