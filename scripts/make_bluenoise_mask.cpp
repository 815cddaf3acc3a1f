// Makes src/sampling/bluenoise_mask.inc, in a few minutes:
//   g++ -std=c++20 -O3 -march=native scripts/make_bluenoise_mask.cpp -o make_mask
//   ./make_mask > src/sampling/bluenoise_mask.inc
//
// The energy of a mask is the sum over pairs of pixels p, q of G(p - q) K(place of p, place of q). G is a Gaussian, so
// in the frequency domain the energy weights only low frequencies. K is the covariance of the errors of two pixels,
// averaged over the integrands that matter: minus the distance between the two places for all half-planes (Crofton), on
// the square and on the disk; minus the differences of their coordinates, for steps. For 2, 4 and 8 rays, K is averaged
// over the points that bluenoise.hpp derives from a pixel's place, and added with a smaller weight.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <random>
#include <vector>

namespace {

constexpr int side = 64;                            // cells along the square
constexpr int cells = side * side;                  // place = column * side + row
constexpr double sigma = 2.8;                       // of the Gaussian, in pixels
constexpr int reach = 9;                            // its radius
constexpr double weights[] = {1, 0.2, 0.08, 0.03};  // of 1, 2, 4, 8 rays

// The points of the indices 1, 2 and 4, whose combinations the first points of the sequence add to a place (by XOR),
// after the linear scrambling of bluenoise.hpp; these are its rows.
constexpr int upper_rows[2][6] = {{0x20, 0x30, 0x38, 0x2c, 0x3e, 0x37}, {0x20, 0x10, 0x08, 0x1c, 0x02, 0x0f}};
int scrambled(int x, const int* rows) {
  int y = 0;
  for (int r = 0; r < 6; r++) y |= (__builtin_popcount(static_cast<unsigned>(x & rows[r])) & 1) << (5 - r);
  return y;
}
int basis_point(int bit) {
  const int first = 32 >> bit;
  int second = 0;  // Pascal's triangle modulo 2
  for (int r = 0; r <= bit; r++) second |= ((bit & r) == r ? 1 : 0) << (5 - r);
  return scrambled(first, upper_rows[0]) * side + scrambled(second, upper_rows[1]);
}

using Kernel = std::vector<float>;  // cells * cells

Kernel covariance() {
  Kernel k(std::size_t{cells} * cells);
  std::vector<double> u(cells), v(cells), x(cells), y(cells);
  for (int c = 0; c < cells; c++) {
    u[c] = (c / side + 0.5) / side;
    v[c] = (c % side + 0.5) / side;
    x[c] = std::sqrt(u[c]) * std::cos(2 * M_PI * v[c]);
    y[c] = std::sqrt(u[c]) * std::sin(2 * M_PI * v[c]);
  }
  for (int a = 0; a < cells; a++) {
    for (int b = 0; b < cells; b++) {
      const double du = u[a] - u[b], dv = v[a] - v[b];
      k[std::size_t(a) * cells + b] = static_cast<float>(
          -(1.6 * std::hypot(du, dv) + 0.4 * std::abs(du) + 0.4 * std::abs(dv) + 0.45 * std::abs(du + dv) +
            0.45 * std::abs(du - dv) + std::hypot(x[a] - x[b], y[a] - y[b])));
    }
  }
  // An error is what remains after subtracting the mean.
  std::vector<double> means(cells);
  double mean = 0;
  for (int a = 0; a < cells; a++) {
    for (int b = 0; b < cells; b++) means[a] += k[std::size_t(a) * cells + b] / cells;
    mean += means[a] / cells;
  }
  for (int a = 0; a < cells; a++) {
    for (int b = 0; b < cells; b++) k[std::size_t(a) * cells + b] += static_cast<float>(mean - means[a] - means[b]);
  }
  return k;
}

Kernel energy_kernel() {
  Kernel one = covariance(), sum(one.size()), next(one.size());
  for (int level = 0; level < 4; level++) {
    double variance = 0;
    for (int a = 0; a < cells; a++) variance += one[std::size_t(a) * cells + a] / cells;
    for (std::size_t i = 0; i < sum.size(); i++) sum[i] += static_cast<float>(weights[level] / variance) * one[i];
    const int g = basis_point(level);
    const auto at = [&](int a, int b) { return one[std::size_t(a) * cells + b]; };
    for (int a = 0; a < cells; a++) {
      for (int b = 0; b < cells; b++) {
        next[std::size_t(a) * cells + b] = 0.25f * (at(a, b) + at(a ^ g, b) + at(a, b ^ g) + at(a ^ g, b ^ g));
      }
    }
    one.swap(next);
  }
  return sum;
}

class Mask {
 public:
  Mask(int size, std::vector<int> places, const Kernel& kernel)
      : size_(size), places_(std::move(places)), kernel_(kernel), field_(places_.size() * cells) {
    for (int p = 0; p < count(); p++) spread(p, -1, places_[p]);
  }

  // Swaps each pixel with the one, among every `stride`th, that lowers the energy most.
  void sweep(int stride, std::mt19937& random) {
    std::vector<int> order(places_.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    int swaps = 0;
    for (const int p : order) {
      const int a = places_[p];
      float best = -1e-6f;
      int with = -1;
      for (int r = static_cast<int>(random() % stride); r < count(); r += stride) {
        const int b = places_[r];
        float change = field(p, b) - field(p, a) + field(r, a) - field(r, b);
        if (r == p || change >= best) continue;
        change += gaussian(p, r) * (k(a, a) + k(b, b) - 2 * k(a, b));
        if (change < best) {
          best = change;
          with = r;
        }
      }
      if (with < 0) continue;
      const int b = places_[with];
      places_[p] = b;
      places_[with] = a;
      spread(p, a, b);
      spread(with, b, a);
      swaps++;
    }
    double energy = 0, alone = 0;
    for (int p = 0; p < count(); p++) {
      energy += field(p, places_[p]);
      alone += k(places_[p], places_[p]);
    }
    std::fprintf(stderr, "%d x %d: %d swaps, energy %.4f of white noise\n", size_, size_, swaps, 1 + energy / alone);
  }

  const std::vector<int>& places() const { return places_; }

 private:
  int count() const { return size_ * size_; }
  float k(int a, int b) const { return kernel_[std::size_t(a) * cells + b]; }
  // The cost of place a at pixel p, given its neighbours.
  float field(int p, int a) const { return field_[std::size_t(p) * cells + a]; }

  float gaussian(int p, int r) const {
    const int half = size_ / 2;
    const int x = (r % size_ - p % size_ + size_ + half) % size_ - half;
    const int y = (r / size_ - p / size_ + size_ + half) % size_ - half;
    if (std::abs(x) > reach || std::abs(y) > reach) return 0;
    return static_cast<float>(std::exp(-(x * x + y * y) / (2 * sigma * sigma)));
  }

  // Updates the fields of the neighbours of p.
  void spread(int p, int from, int to) {
    for (int y = -reach; y <= reach; y++) {
      for (int x = -reach; x <= reach; x++) {
        if (x == 0 && y == 0) continue;
        const float g = static_cast<float>(std::exp(-(x * x + y * y) / (2 * sigma * sigma)));
        const int q = (p / size_ + y + size_) % size_ * size_ + (p % size_ + x + size_) % size_;
        float* f = &field_[std::size_t(q) * cells];
        const float* k1 = &kernel_[std::size_t(to) * cells];
        const float* k0 = from < 0 ? nullptr : &kernel_[std::size_t(from) * cells];
        for (int i = 0; i < cells; i++) f[i] += g * (k0 ? k1[i] - k0[i] : k1[i]);
      }
    }
  }

  int size_;
  std::vector<int> places_;
  const Kernel& kernel_;
  std::vector<float> field_;
};

// Four copies of the 64 x 64 mask, shifted, mirrored and transposed, as the start for the 128 x 128 one.
std::vector<int> four_of(const std::vector<int>& mask) {
  std::vector<int> places(4 * cells);
  for (int y = 0; y < 2 * side; y++) {
    for (int x = 0; x < 2 * side; x++) {
      const int tile = y / side * 2 + x / side;
      int a = (x + 17 * tile * tile + 5 * tile) % side, b = (y + 29 * tile) % side;
      if (tile & 1) a = side - 1 - a;
      if (tile & 2) std::swap(a, b);
      places[y * 2 * side + x] = mask[b * side + a];
    }
  }
  return places;
}

}  // namespace

int main() {
  const Kernel kernel = energy_kernel();
  std::mt19937 random(1);
  std::vector<int> places(cells);
  std::iota(places.begin(), places.end(), 0);
  std::shuffle(places.begin(), places.end(), random);
  {
    Mask quarter(side, places, kernel);
    for (int i = 0; i < 12; i++) quarter.sweep(1, random);
    places = four_of(quarter.places());
  }
  Mask mask(2 * side, places, kernel);
  for (int i = 0; i < 10; i++) mask.sweep(5, random);
  const char* digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-";
  for (int i = 0; i < 4 * cells; i += side) {
    std::printf("\"");
    for (int k = i; k < i + side; k++) {
      std::printf("%c%c", digits[mask.places()[k] / side], digits[mask.places()[k] % side]);
    }
    std::printf("\"\n");
  }
}
