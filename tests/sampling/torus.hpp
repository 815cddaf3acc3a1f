// Checks of point sets on the unit torus: the distance of the nearest two, and whether every place is near a point.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra::test {

struct TorusPoint {
  double u, v;
};

inline double torus_distance(TorusPoint a, TorusPoint b) {
  const double du = std::abs(a.u - b.u), dv = std::abs(a.v - b.v);
  return std::hypot(std::min(du, 1 - du), std::min(dv, 1 - dv));
}

// The least distance between two of the points, or of a point and its image.
inline double least_distance(const std::vector<TorusPoint>& points) {
  double least = 1;
  for (std::size_t i = 0; i < points.size(); i++) {
    for (std::size_t k = 0; k < i; k++) least = std::min(least, torus_distance(points[i], points[k]));
  }
  return least;
}

// Whether every place of the square around `centre` is within `distance` of a point, proved by squares that lie wholly
// within that distance of one point. Only places within 2^-24 of the limit stay undecided, and count as not covered.
inline bool is_covered(const std::vector<TorusPoint>& points, double distance, TorusPoint centre = {0.5, 0.5},
                       double half = 0.5) {
  const double reach = half * std::sqrt(2.0);
  std::vector<TorusPoint> near;  // those that cover a part of the square
  double nearest = 2;
  for (const TorusPoint p : points) {
    const double d = torus_distance(p, centre);
    nearest = std::min(nearest, d);
    if (d <= distance + reach) near.push_back(p);
  }
  if (nearest + reach <= distance) return true;
  if (nearest > distance || half < 0x1p-24) return false;
  const double h = half / 2;
  return is_covered(near, distance, {centre.u - h, centre.v - h}, h) &&
         is_covered(near, distance, {centre.u + h, centre.v - h}, h) &&
         is_covered(near, distance, {centre.u - h, centre.v + h}, h) &&
         is_covered(near, distance, {centre.u + h, centre.v + h}, h);
}

}  // namespace penumbra::test
