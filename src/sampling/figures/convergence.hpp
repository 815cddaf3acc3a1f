// Measures how fast the error of a mean over n sample points falls with n: the slope of the logarithm of the variance
// against the logarithm of n. It is -1 for random points. For jittered points it is -2 for smooth functions and -1.5
// for edges (Mitchell, "Consequences of stratified sampling in graphics", 1996).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "sampling/figures/plane_point.hpp"

namespace penumbra {

struct Convergence {
  double smooth = 0;  // slope for exp(-x^2 - y^2)
  double edges = 0;   // slope for the mean variance over 50 random half-planes
};

// The pattern's points for `count` samples, in its realization number `replicate`.
using PatternSource = std::function<std::vector<PlanePoint>(std::size_t count, int replicate)>;

// Fits the least-squares line through 16, 32, ..., 1024 points. The variance is the mean squared difference from the
// true integral over `replicates` realizations, so it includes the bias of a biased pattern.
Convergence measure_convergence(const PatternSource& source, int replicates);

// The points with a x + b y <= c.
struct HalfPlane {
  double a, b, c;
};

// The area of the part of the unit square inside the half-plane; neither a nor b may be 0.
double area_in_unit_square(HalfPlane half_plane);

}  // namespace penumbra
