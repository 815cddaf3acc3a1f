// How evenly points are spread over the unit square with opposite edges joined (a torus, because the pattern of a pixel
// meets similar ones there): the smallest distance between two points, and the largest circle that contains none, both
// exact but for rounding. The best arrangement of n points is the hexagonal lattice, with cells of area 1/n.
#pragma once

#include <cstddef>
#include <span>

#include "sampling/figures/plane_point.hpp"

namespace penumbra {

struct ClosestPair {
  double distance = 0;
  std::size_t a = 0, b = 0;
};

// The two closest points on the torus; a single point has distance 1, that to its own copies.
ClosestPair closest_pair(std::span<const PlanePoint> points);

struct EmptyCircle {
  double radius = 0;
  PlanePoint centre;
};

// The largest circle on the torus with no point inside. Its centre is a corner of a Voronoi cell: each cell is cut out
// of the square around its point by the bisectors to all points that are near enough to matter.
EmptyCircle largest_empty_circle(std::span<const PlanePoint> points);

// The smallest distance of n points on the torus is at most sqrt(2 / (sqrt(3) n)), that of the densest packing.
double largest_possible_distance(std::size_t n);

// The largest empty circle of n points on the torus has at least the radius sqrt(2 / (3 sqrt(3) n)), that of the
// thinnest covering (Kershner 1939).
double smallest_possible_circle(std::size_t n);

}  // namespace penumbra
