// Polygons, convex or not, as triangles. A polygon is seen along the axis from which it looks largest. A fan from its
// first corner remains one if no triangle of it turns over; else ears are cut off (Meisters 1975).
//
// Whatever the outline, each triangle cut off takes its own winding number out of that of the rest. So everything that
// the outline winds round is covered: once if it is the edge of an area, and perhaps more than once if it crosses
// itself.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scene/scene.hpp"

namespace penumbra {

// A polygon that needs ears has at most this many corners: the time grows with the square of their number.
inline constexpr std::size_t most_concave_corners = 10'000;

// Appends the n - 2 triangles of a polygon to the store, given its n >= 3 corners as vertices of the store and, where
// these have normals, their numbers. Returns what is wrong; empty if nothing is.
std::string append_polygon(TriangleStore& store, std::span<const std::uint32_t> corners,
                           std::span<const std::uint32_t> normals = {});

}  // namespace penumbra
