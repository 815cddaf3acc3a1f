// Whether a run of triangles has some that lie on each other, so that ties between them have to be settled.
#pragma once

#include <span>

#include "scene/scene.hpp"

namespace penumbra {

// Whether two of these triangles have the same three corners, in whatever order. May say so of others too, about once
// in 2^64 pairs. Takes some 30 ns a triangle and, while it runs, five bytes.
bool any_coincide(const TriangleStore& store, std::span<const TriangleRange> ranges);

}  // namespace penumbra
