// The power spectrum of sample points, after Ulichney, "Digital halftoning" (1987), and Lagae and Dutre, "A comparison
// of methods for generating Poisson disk distributions" (2008): the periodogram
//   P(f) = |sum_j exp(-2 pi i f.x_j)|^2 / n
// at integer frequencies, averaged over several realizations of the pattern. Independent random points have P = 1
// everywhere (white noise).
#pragma once

#include <span>
#include <vector>

#include "sampling/figures/figures.hpp"

namespace penumbra {

class Spectrum {
 public:
  // Frequencies of -limit .. limit in x and y.
  explicit Spectrum(int limit);

  // Adds one realization. Takes O(n limit^2).
  void add(std::span<const PlanePoint> points);

  int limit() const { return limit_; }
  int realizations() const { return realizations_; }

  // P at one frequency, the mean over the realizations so far; n at frequency 0.
  double power(int fx, int fy) const;

  // Element k = 1 .. limit is the mean over the ring of frequencies with |f| nearest to k; element 0 is 0.
  std::vector<double> radial() const;

 private:
  std::size_t place(int fx, int fy) const;

  int limit_;
  int realizations_ = 0;
  std::vector<double> sums_;  // of P, for fy = 0 .. limit and fx = -limit .. limit; P(-f) = P(f)
};

}  // namespace penumbra
