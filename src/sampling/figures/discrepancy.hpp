// Star discrepancies of points in the unit square: how much the fraction of the points in a box [0, x) x [0, y) differs
// from the area of the box. After Warnock, "Computational investigations of low-discrepancy point sets" (1972), and
// Bundschuh and Zhu, "A method for exact calculation of the discrepancy of low-dimensional finite point sets" (1993).
#pragma once

#include <span>

#include "sampling/figures/plane_point.hpp"

namespace penumbra {

// The root of the mean square over all boxes (Warnock's formula for two dimensions, exact):
//   T^2 = 1/9 - 1/(2n) sum_i (1 - x_i^2)(1 - y_i^2) + 1/n^2 sum_ij (1 - max(x_i, x_j))(1 - max(y_i, y_j)).
// n independent random points have T^2 = 5/(36 n) on average. Takes O(n log n).
double l2_star_discrepancy(std::span<const PlanePoint> points);

// The largest over all boxes, exact: only boxes whose upper sides pass through points or end at 1 matter. With the
// points in order of x, and the first l of them in order of y (0 in front, 1 behind),
//   D = max over l, k of |k/n - x_l y_k| and |k/n - x_{l+1} y_{k+1}|.
// Takes O(n^2).
double star_discrepancy(std::span<const PlanePoint> points);

}  // namespace penumbra
