// The plot of `penumbra samples`: the points in the unit square, their power spectrum as grey values, and its mean
// over all directions as a curve.
#pragma once

#include <vector>

#include "image/image.hpp"
#include "sampling/figures/figures.hpp"
#include "sampling/figures/spectrum.hpp"

namespace penumbra {

inline constexpr int plot_width = 1260, plot_height = 420;

struct PatternPlot {
  const std::vector<PlanePoint>& points;
  const ClosestPair& closest;
  const EmptyCircle& empty;
  const Spectrum& spectrum;
};

// Three panels:
// - the points on the grid of n equal cells, as they lie in a pixel (y down); the closest two in red, the largest empty
//   circle in blue;
// - P(f), with frequency 0 (left out) in the middle, as the grey value P / (1 + P): black for 0, mid grey for 1 (white
//   noise), white for infinity. Ticks are at multiples of sqrt(n);
// - the radial mean of P from 0 to 3, with a line at 1 for white noise; the same ticks along the frequency.
Image draw_pattern(const PatternPlot& plot);

}  // namespace penumbra
