// How fast the error of a mean over n sample points falls with n, measured: the slope of the logarithm of the variance
// against the logarithm of n. Random points have -1. Jittered points have -2 for smooth functions and -1.5 for edges
// (Mitchell, "Consequences of stratified sampling in graphics", 1996).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "sampling/figures/plane_point.hpp"

namespace penumbra {

struct Convergence {
  double smooth = 0;  // slope for exp(-x^2 - y^2)
  double edges = 0;   // slope for the mean variance over 50 half-planes at random
};

// Points of the pattern for `count` samples in its realization number `replicate`.
using PatternSource = std::function<std::vector<PlanePoint>(std::size_t count, int replicate)>;

// The line of least squares through 16, 32, .. 1024 points. The variance is the mean square of the difference from the
// true integral, over `replicates` realizations: for a pattern with a bias, that is in it.
Convergence measure_convergence(const PatternSource& source, int replicates);

// The points with a x + b y <= c.
struct HalfPlane {
  double a, b, c;
};

// The area of the part of the unit square that lies in it; neither a nor b may be 0.
double area_in_unit_square(HalfPlane half_plane);

}  // namespace penumbra
