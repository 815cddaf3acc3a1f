#include "sampling/figures/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace penumbra {
namespace {

// Points added together, so that the sums are fetched once for all of them.
constexpr std::size_t block = 8;

// Cosines and sines of 2 pi f x for f = 0 .. size-1, one row for each point of a block.
struct Waves {
  explicit Waves(std::size_t size_) : size(size_), cosines(block * size_), sines(block * size_) {}

  void set(std::size_t point, double x) {
    // A recurrence in double precision is accurate enough for float tables.
    const std::complex<double> turn = std::polar(1.0, 2 * std::numbers::pi * x);
    std::complex<double> wave = 1;
    for (std::size_t f = 0; f < size; f++) {
      cosines[point * size + f] = static_cast<float>(wave.real());
      sines[point * size + f] = static_cast<float>(wave.imag());
      wave = {wave.real() * turn.real() - wave.imag() * turn.imag(),
              wave.real() * turn.imag() + wave.imag() * turn.real()};
    }
  }

  std::size_t size;
  std::vector<float> cosines, sines;
};

// a[f] += sum over the block of rows[point][f] * weight_a[point], and the same for b.
void add_rows(float* __restrict a, float* __restrict b, const float* __restrict rows, const float* __restrict weight_a,
              const float* __restrict weight_b, std::size_t size) {
  for (std::size_t f = 0; f < size; f++) {
    float sum_a = a[f], sum_b = b[f];
    for (std::size_t point = 0; point < block; point++) {
      const float value = rows[point * size + f];
      sum_a += value * weight_a[point];
      sum_b += value * weight_b[point];
    }
    a[f] = sum_a;
    b[f] = sum_b;
  }
}

}  // namespace

Spectrum::Spectrum(int limit)
    : limit_(limit), sums_(static_cast<std::size_t>(limit + 1) * static_cast<std::size_t>(2 * limit + 1)) {}

std::size_t Spectrum::place(int fx, int fy) const {
  return static_cast<std::size_t>(fy) * static_cast<std::size_t>(2 * limit_ + 1) +
         static_cast<std::size_t>(fx + limit_);
}

void Spectrum::add(std::span<const PlanePoint> points) {
  // The wave of a point is the product of a wave in x and one in y, so four real sums of products over fx, fy >= 0 give
  // the frequencies (fx, fy) and (-fx, fy).
  const std::size_t size = static_cast<std::size_t>(limit_) + 1;
  std::vector<float> cc(size * size), cs(size * size), sc(size * size), ss(size * size);
  Waves x(size), y(size);
  for (std::size_t first = 0; first < points.size(); first += block) {
    for (std::size_t i = 0; i < block; i++) {
      const bool exists = first + i < points.size();
      if (exists) x.set(i, points[first + i].x);
      if (exists) y.set(i, points[first + i].y);
    }
    for (std::size_t fy = 0; fy < size; fy++) {
      float cosine[block], sine[block];
      for (std::size_t i = 0; i < block; i++) {
        const bool exists = first + i < points.size();
        cosine[i] = exists ? y.cosines[i * size + fy] : 0.0f;
        sine[i] = exists ? y.sines[i * size + fy] : 0.0f;
      }
      add_rows(&cc[fy * size], &cs[fy * size], x.cosines.data(), cosine, sine, size);
      add_rows(&sc[fy * size], &ss[fy * size], x.sines.data(), cosine, sine, size);
    }
  }
  const auto n = static_cast<double>(points.size());
  for (int fy = 0; fy <= limit_; fy++) {
    for (int fx = 0; fx <= limit_; fx++) {
      const std::size_t i = static_cast<std::size_t>(fy) * size + static_cast<std::size_t>(fx);
      const auto power_of = [n](double real, double imaginary) { return (real * real + imaginary * imaginary) / n; };
      sums_[place(fx, fy)] += power_of(double{cc[i]} - ss[i], double{sc[i]} + cs[i]);
      if (fx > 0) sums_[place(-fx, fy)] += power_of(double{cc[i]} + ss[i], double{cs[i]} - sc[i]);
    }
  }
  realizations_++;
}

double Spectrum::power(int fx, int fy) const {
  return (fy < 0 ? sums_[place(-fx, -fy)] : sums_[place(fx, fy)]) / realizations_;
}

std::vector<double> Spectrum::radial() const {
  std::vector<double> sums(static_cast<std::size_t>(limit_) + 1), counts(sums.size());
  for (int fy = -limit_; fy <= limit_; fy++) {
    for (int fx = -limit_; fx <= limit_; fx++) {
      const auto ring = static_cast<std::size_t>(std::lround(std::hypot(fx, fy)));
      if (ring == 0 || ring >= sums.size()) continue;
      sums[ring] += power(fx, fy);
      counts[ring]++;
    }
  }
  for (std::size_t k = 1; k < sums.size(); k++) sums[k] /= counts[k];
  return sums;
}

}  // namespace penumbra
