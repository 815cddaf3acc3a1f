// The spectrum against the sum as written, the peaks of a grid, and white noise.
#include "sampling/figures/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "base/test_scale.hpp"
#include "figures/plane_points.hpp"
#include "sampling/statistics.hpp"

namespace penumbra::test {
namespace {

double periodogram(const std::vector<PlanePoint>& points, int fx, int fy) {
  std::complex<double> sum = 0;
  for (const PlanePoint& p : points) sum += std::polar(1.0, -2 * std::numbers::pi * (fx * p.x + fy * p.y));
  return std::norm(sum) / static_cast<double>(points.size());
}

TEST(PowerSpectrum, IsTheMeanOfPeriodograms) {
  std::mt19937 random(1);
  for (const int n : {1, 7, 8, 30}) {
    const std::vector<PlanePoint> first = random_points(random, n), second = random_points(random, n);
    Spectrum spectrum(9);
    spectrum.add(first);
    spectrum.add(second);
    EXPECT_EQ(spectrum.realizations(), 2);
    for (int fy = -9; fy <= 9; fy++) {
      for (int fx = -9; fx <= 9; fx++) {
        const double expected = (periodogram(first, fx, fy) + periodogram(second, fx, fy)) / 2;
        ASSERT_NEAR(spectrum.power(fx, fy), expected, 1e-5 * n) << n << ": " << fx << " " << fy;
      }
    }
  }
}

TEST(PowerSpectrum, OfARegularGridIsPeaks) {
  constexpr int m = 8;
  Spectrum spectrum(20);
  spectrum.add(regular_grid(m));
  for (int fy = -20; fy <= 20; fy++) {
    for (int fx = -20; fx <= 20; fx++) {
      EXPECT_NEAR(spectrum.power(fx, fy), fx % m == 0 && fy % m == 0 ? m * m : 0, 1e-3);
    }
  }
}

// Each ring holds all frequencies whose length rounds to its number, and no others.
TEST(PowerSpectrum, RadialMeans) {
  Spectrum spectrum(20);
  spectrum.add(regular_grid(8));
  const std::vector<double> radial = spectrum.radial();
  ASSERT_EQ(radial.size(), 21u);
  for (int k = 1; k <= 20; k++) {
    double sum = 0, count = 0;
    for (int fy = -20; fy <= 20; fy++) {
      for (int fx = -20; fx <= 20; fx++) {
        const double length = std::sqrt(fx * fx + fy * fy);
        if (length <= k - 0.5 || length >= k + 0.5) continue;
        sum += spectrum.power(fx, fy);
        count++;
      }
    }
    EXPECT_NEAR(radial[static_cast<std::size_t>(k)], sum / count, 1e-9) << k;
  }
}

// Random points are white: P has mean 1 at every frequency and is close to exponential, and different frequencies are
// uncorrelated. Only f and -f are the same, so a ring of N frequencies has N degrees of freedom per realization.
TEST(PowerSpectrum, OfRandomPointsIsWhite) {
  std::mt19937 random(2);
  constexpr int limit = 32, realizations = scaled(256, 32);
  Spectrum spectrum(limit);
  for (int i = 0; i < realizations; i++) spectrum.add(random_points(random, 256));
  const std::vector<double> radial = spectrum.radial();
  std::vector<int> counts(limit + 1);
  for (int fy = -limit; fy <= limit; fy++) {
    for (int fx = -limit; fx <= limit; fx++) {
      const auto ring = static_cast<std::size_t>(std::lround(std::hypot(fx, fy)));
      if (ring <= limit) counts[ring]++;
    }
  }
  for (std::size_t k = 1; k <= limit; k++) {
    const double freedom = static_cast<double>(counts[k]) * realizations;
    const double deviation = (std::cbrt(radial[k]) - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
    EXPECT_LT(std::abs(deviation), normal_limit(2.0 * limit)) << k;
  }
}

}  // namespace
}  // namespace penumbra::test
