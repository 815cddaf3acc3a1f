// The few statistics that the tests of randomness need. A test that looks at many numbers passes as a whole for all but
// one seed in a million: the limit for each number is Sidak's.
#pragma once

#include <cmath>
#include <vector>

namespace penumbra::test {

inline constexpr double error_rate = 1e-6;

// The one-sided limit that all of `count` independent standard normal numbers stay below, except with the probability
// error_rate.
inline double normal_limit(double count) {
  const double tail = -std::expm1(std::log1p(-error_rate) / count);
  double lo = 0, hi = 20;
  for (int i = 0; i < 100; i++) {
    const double middle = (lo + hi) / 2;
    (std::erfc(middle / std::sqrt(2.0)) / 2 > tail ? lo : hi) = middle;
  }
  return hi;
}

// How far the counts are from equal, as a standard normal number: Pearson's chi-square by Wilson and Hilferty.
inline double chi_square_deviation(const std::vector<int>& counts) {
  double total = 0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  double chi_square = 0;
  for (const int count : counts) chi_square += (count - expected) * (count - expected) / expected;
  const double freedom = static_cast<double>(counts.size()) - 1;
  return (std::cbrt(chi_square / freedom) - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
}

inline double correlation(const std::vector<float>& a, const std::vector<float>& b) {
  const auto n = static_cast<double>(a.size());
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = 0; i < a.size(); i++) {
    sa += a[i];
    sb += b[i];
    saa += double{a[i]} * a[i];
    sbb += double{b[i]} * b[i];
    sab += double{a[i]} * b[i];
  }
  return (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

}  // namespace penumbra::test
