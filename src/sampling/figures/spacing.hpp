// How evenly points are spread over the unit square with its edges joined (the torus, for the pattern of a pixel meets
// its like at the edges): the smallest distance of two points, and the largest circle that holds none. Both are exact
// but for rounding. The best that n points can do is the hexagonal lattice, with cells of area 1/n.
#pragma once

#include <cstddef>
#include <span>

#include "sampling/figures/plane_point.hpp"

namespace penumbra {

struct ClosestPair {
  double distance = 0;
  std::size_t a = 0, b = 0;
};

// The two points with the smallest distance on the torus; a single point has distance 1, that to its own copies.
ClosestPair closest_pair(std::span<const PlanePoint> points);

struct EmptyCircle {
  double radius = 0;
  PlanePoint centre;
};

// The largest circle on the torus with no point inside. Its centre is the corner of a Voronoi cell: each cell is cut
// out of the square around its point by the bisectors to all points that are near enough to matter.
EmptyCircle largest_empty_circle(std::span<const PlanePoint> points);

// No n points on the torus have a larger smallest distance: sqrt(2 / (sqrt(3) n)), the densest packing.
double largest_possible_distance(std::size_t n);

// No n points on the torus leave all empty circles smaller: sqrt(2 / (3 sqrt(3) n)), the thinnest covering (Kershner
// 1939).
double smallest_possible_circle(std::size_t n);

}  // namespace penumbra
