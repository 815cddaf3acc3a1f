// What a traversal of one group carries along for its rays, and where they are inside the bounds of a node: by slabs
// (Kay and Kajiya 1986).
#pragma once

#include "geometry/rays.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// One over the direction, finite where it is zero, so that no bound of a slab is ever not a number.
PENUMBRA_INLINE Float3 safe_inverse(Float3 direction) {
  const Float3 d = divisor(direction);
  return {Floats(1) / d.x, Floats(1) / d.y, Floats(1) / d.z};
}

// Which of a node's bounds each axis enters and leaves by, where all rays of a packet agree: it halves the work of a
// slab.
struct SlabOrder {
  bool agreed = true;
  int enter[3], leave[3];

  // In place: to copy what was only just written piece by piece makes the processor wait.
  PENUMBRA_INLINE void find(Float3 inverse_direction, Mask active) {
    const Floats axes[3] = {inverse_direction.x, inverse_direction.y, inverse_direction.z};
    for (int axis = 0; axis < 3; axis++) {
      const Mask forward = active & (axes[axis] > Floats(0));
      const bool any_forward = any(forward);
      agreed = agreed && (!any_forward || bits(forward) == bits(active));
      enter[axis] = any_forward ? axis : 3 + axis;
      leave[axis] = any_forward ? 3 + axis : axis;
    }
  }
};

inline constexpr std::uint32_t no_leaf = 0xffffffffu;

// Nothing is prepared that a group of few shapes does not need.
struct GroupRays {
  const World& world;
  const Rays& rays;
  Mask active;
  const float* origin;  // WorldGroup::origin
  Float3 inverse_direction;
  SlabOrder order;

  PENUMBRA_INLINE GroupRays(const World& w, const WorldGroup& group, const Rays& r, Mask lanes)
      : world(w), rays(r), active(lanes), origin(group.origin) {
    if (r.start) {
      many_places_ = !r.start->one_place;
      if (!many_places_) own_place_ = r.start->the_place - r.first_place;
    }
    if (!is_leaf(group.root)) {
      inverse_direction = safe_inverse(r.direction);
      order.find(inverse_direction, active);
    }
  }

  // Hits::place of a leaf of the group; whether all rays start there, or not all at one place.
  PENUMBRA_INLINE std::uint32_t place_of(const Leaf& leaf) const { return rays.first_place + leaf.place; }
  PENUMBRA_INLINE bool all_start_on(const Leaf& leaf) const { return leaf.place == own_place_; }
  PENUMBRA_INLINE bool many_places() const { return many_places_; }

  // Computed for the first triangle that may be met.
  PENUMBRA_INLINE const RayShear& shear() const {
    if (!has_shear_) shear_ = RayShear(rays.direction, active);
    has_shear_ = true;
    return shear_;
  }

  // Where the rays are inside the bounds of a node's child.
  template <bool agreed>
  PENUMBRA_INLINE Interval inside(const float* bounds) const {
    if constexpr (!agreed) {
      const Float3 a = (broadcast3(bounds) - rays.origin) * inverse_direction;
      const Float3 b = (broadcast3(bounds + 3) - rays.origin) * inverse_direction;
      return {max(max(min(a.x, b.x), min(a.y, b.y)), min(a.z, b.z)),
              min(min(max(a.x, b.x), max(a.y, b.y)), max(a.z, b.z))};
    }
    const Floats enter_x = (Floats(bounds[order.enter[0]]) - rays.origin.x) * inverse_direction.x;
    const Floats enter_y = (Floats(bounds[order.enter[1]]) - rays.origin.y) * inverse_direction.y;
    const Floats enter_z = (Floats(bounds[order.enter[2]]) - rays.origin.z) * inverse_direction.z;
    const Floats leave_x = (Floats(bounds[order.leave[0]]) - rays.origin.x) * inverse_direction.x;
    const Floats leave_y = (Floats(bounds[order.leave[1]]) - rays.origin.y) * inverse_direction.y;
    const Floats leave_z = (Floats(bounds[order.leave[2]]) - rays.origin.z) * inverse_direction.z;
    return {max(max(enter_x, enter_y), enter_z), min(min(leave_x, leave_y), leave_z)};
  }

 private:
  std::uint32_t own_place_ = no_place;  // of the leaf that all rays start on
  bool many_places_ = false;            // they start on several
  mutable RayShear shear_;
  mutable bool has_shear_ = false;
};

}  // namespace penumbra::PENUMBRA_KERNEL
