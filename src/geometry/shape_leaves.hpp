// Analytic shapes become leaves of a group, long lists of them on all threads.
#pragma once

#include <span>

#include "geometry/group_leaves.hpp"

namespace penumbra {

inline bool is_analytic(const Object& object) {
  return std::visit([]<typename Kind>(const Kind&) { return AnalyticShape<Kind>; }, object.shape);
}

// Adds objects, all of them analytic shapes, as leaves in this order. `outer` maps the space that they are placed in to
// that of the group, where `motion` is added to theirs.
void add_shapes(World& world, GroupLeaves& group, const Scene& scene, const WorldOptions& options,
                std::span<const Object> objects, const Affine& outer, Vec3 motion);

}  // namespace penumbra
