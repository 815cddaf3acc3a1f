// A leaf of the world, and the list of the shapes that it may hold. All that is known of a shape is in its own file
// (geometry/shapes/shape.hpp).
#pragma once

#include <cstdint>

#include "geometry/shapes/box.hpp"
#include "geometry/shapes/cone.hpp"
#include "geometry/shapes/cylinder.hpp"
#include "geometry/shapes/sphere.hpp"
#include "geometry/shapes/triangle.hpp"

namespace penumbra {

// A mesh and an instance stand for more than one shape.
enum class LeafKind : std::uint8_t { sphere, box, cylinder, cone, triangle, mesh, instance };

inline constexpr std::uint32_t no_placement = 0xffffffffu;
inline constexpr std::uint32_t no_place = 0xffffffffu;

// What light does at a surface: it stays outside, it enters or leaves a solid, or it goes through a sheet.
enum class Passage : std::uint8_t { opaque, solid, sheet };

// In which order a ray crosses surfaces that lie on each other; the two highest bits of an order, so that the one to be
// crossed first wins a tie.
enum TouchRank : std::uint32_t { touch_out = 0, touch_sheet = 1, touch_opaque = 2, touch_into = 3 };
inline constexpr int touch_rank_shift = 30;
inline constexpr std::uint32_t order_mask = (1u << touch_rank_shift) - 1;

// The order of a surface that is met from outside.
constexpr std::uint32_t touch_order(Passage passage, std::uint32_t order) {
  const TouchRank rank = passage == Passage::opaque  ? touch_opaque
                         : passage == Passage::sheet ? touch_sheet
                                                     : touch_into;
  return order | (std::uint32_t{rank} << touch_rank_shift);
}

// One shape of a group, in the space of the group (or of its placement, where it has one).
struct Leaf {
  LeafKind kind;
  Passage passage = Passage::opaque;
  bool moves = false;        // `motion` is not zero
  std::uint32_t order = 0;   // at equal distance the lower one wins; with the rank of a surface met from outside
  std::uint32_t target = 0;  // the surface; of a mesh its index in World::meshes, of an instance the group
  std::uint32_t placement = no_placement;
  std::uint32_t place = 0;  // Hits::place, counted from Rays::first_place; of an instance: what that grows by inside it
  float motion[3] = {0, 0, 0};  // shift per unit of time, in the space of the group
  float slack = 0;              // how far a computed hit may be off the surface, beside the rounding of its point
  union {                       // the one of `kind`
    LeafSphere sphere = {};
    LeafBox box;
    LeafCylinder cylinder;
    LeafCone cone;
    LeafTriangle triangle;
  };

  explicit Leaf(const LeafSphere& s) : kind(LeafKind::sphere), sphere(s) {}
  explicit Leaf(const LeafBox& b) : kind(LeafKind::box), box(b) {}
  explicit Leaf(const LeafCylinder& c) : kind(LeafKind::cylinder), cylinder(c) {}
  explicit Leaf(const LeafCone& c) : kind(LeafKind::cone), cone(c) {}
  explicit Leaf(const LeafTriangle& t) : kind(LeafKind::triangle), triangle(t) {}
  explicit Leaf(LeafKind nested) : kind(nested) {}

  bool is_nested() const { return kind == LeafKind::mesh || kind == LeafKind::instance; }
};

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

// Calls `visit` with the shape of a leaf that is not nested.
template <typename Visit>
PENUMBRA_INLINE auto with_shape(const Leaf& leaf, Visit visit) {
  switch (leaf.kind) {
    case LeafKind::sphere:
      return visit(leaf.sphere);
    case LeafKind::box:
      return visit(leaf.box);
    case LeafKind::cylinder:
      return visit(leaf.cylinder);
    case LeafKind::cone:
      return visit(leaf.cone);
    case LeafKind::triangle:
      return visit(leaf.triangle);
    case LeafKind::mesh:
    case LeafKind::instance:
      break;
  }
  __builtin_unreachable();
}

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
