// Sobol's sequence (Sobol 1967), scrambled after Owen (1995): each bit of a coordinate is flipped or not according to a
// hash of the bits before it. The polynomial and the initial numbers of each dimension of an eye ray were found by
// search (bench/direction_numbers.cpp): edges run through the pixel and the lens, the pixel and the light, the pixel
// and time, so the points must be spread evenly over these together. With 64 to 256 rays per pixel, the error is 0.9 of
// that of the usual order with the numbers of Joe and Kuo (2008) in soft shadows, 0.8 in motion blur.
#include "sampling/sample_tables.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "base/hash.hpp"

namespace penumbra {
namespace {

// Degree, coefficients and initial numbers of the primitive polynomials. The first dimension, pixel_x, needs none.
struct Polynomial {
  int degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 5> initial;
};
constexpr std::array<Polynomial, joint_dimension_count - 1> polynomials{{
    {1, 0, {1}},                 // pixel_y
    {4, 4, {1, 3, 1, 3}},        // lens_radius
    {5, 13, {1, 1, 5, 15, 21}},  // lens_angle
    {2, 1, {1, 3}},              // first_light_radius
    {3, 1, {1, 1, 3}},           // first_light_angle
    {3, 2, {1, 1, 5}},           // shutter_time
}};

using Directions = std::array<std::uint32_t, 32>;

Directions direction_numbers(std::uint32_t dimension) {
  Directions v{};
  if (dimension == 0) {
    for (int i = 0; i < 32; i++) v[i] = 1u << (31 - i);
    return v;
  }
  const Polynomial& p = polynomials[dimension - 1];
  for (int i = 0; i < p.degree; i++) v[i] = p.initial[i] << (31 - i);
  for (int i = p.degree; i < 32; i++) {
    v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
    for (int k = 1; k < p.degree; k++) {
      if ((p.coefficients >> (p.degree - 1 - k)) & 1) v[i] ^= v[i - k];
    }
  }
  return v;
}

// Owen's nested uniform scrambling: the bits before a bit decide whether it is flipped. One hash of the bits so far
// decides on the next four: their choices form a tree of fifteen. No two of the first 2^16 points share their first
// sixteen bits, so the rest is simply random.
class OwenScrambling {
 public:
  // For the first `points` points of a sequence in base 2. Together they have all possible leading digits, which are
  // therefore scrambled once for all points.
  OwenScrambling(std::uint32_t points, std::uint32_t seed) : seed_(seed), beginnings_{0} {
    while ((std::uint64_t{1} << (known_bits_ + digit_bits)) <= points && known_bits_ < shared_bits) {
      std::vector<std::uint32_t> longer;
      longer.reserve(beginnings_.size() << digit_bits);
      for (std::uint32_t prefix = 0; prefix < beginnings_.size(); prefix++) {
        const std::uint32_t choices = choices_after(prefix, known_bits_);
        for (std::uint32_t digit = 0; digit < 1u << digit_bits; digit++) {
          longer.push_back(beginnings_[prefix] << digit_bits | scrambled(digit, choices));
        }
      }
      beginnings_ = std::move(longer);
      known_bits_ += digit_bits;
    }
  }

  std::uint32_t operator()(std::uint32_t x) const {
    std::uint32_t result = beginnings_[std::uint64_t{x} >> (32 - known_bits_)];
    for (int bits = known_bits_; bits < shared_bits; bits += digit_bits) {
      const auto prefix = static_cast<std::uint32_t>(std::uint64_t{x} >> (32 - bits));
      const std::uint32_t digit = x >> (32 - bits - digit_bits) & ((1u << digit_bits) - 1);
      result = result << digit_bits | scrambled(digit, choices_after(prefix, bits));
    }
    return result << (32 - shared_bits) | (hash(seed_, (x >> shared_bits) | (1u << shared_bits)) & 0xffffu);
  }

 private:
  static constexpr int shared_bits = 16, digit_bits = 4;

  // The hash includes a marker of how many bits the prefix has.
  std::uint32_t choices_after(std::uint32_t prefix, int bits) const { return hash(seed_, prefix | (1u << bits)); }

  static std::uint32_t scrambled(std::uint32_t digit, std::uint32_t choices) {
    std::uint32_t result = 0, node = 1;
    for (int i = digit_bits - 1; i >= 0; i--) {
      const std::uint32_t bit = digit >> i & 1;
      result = result << 1 | (bit ^ (choices >> node & 1));
      node = 2 * node + bit;
    }
    return result;
  }

  std::uint32_t seed_;
  int known_bits_ = 0;
  std::vector<std::uint32_t> beginnings_;  // all prefixes of `known_bits_` bits, scrambled
};

}  // namespace

SobolTable make_sobol_table(std::uint32_t count, std::uint32_t seed) {
  SobolTable table;
  table.size = std::min((std::max(count, 1u) + 31) / 32 * 32, largest_sobol_table);
  table.values.resize(std::size_t{table.size} * joint_dimension_count);
  for (std::uint32_t dimension = 0; dimension < joint_dimension_count; dimension++) {
    const Directions v = direction_numbers(dimension);
    const OwenScrambling scramble(table.size, hash(seed, dimension + 1));
    std::uint32_t* points = table.values.data() + std::size_t{dimension} * table.size;
    for (std::uint32_t index = 1; index < table.size; index++) {
      points[index] = points[index & (index - 1)] ^ v[static_cast<std::size_t>(std::countr_zero(index))];
    }
    for (std::uint32_t index = 0; index < table.size; index++) {
      points[index] = scramble(points[index]);
    }
  }
  return table;
}

}  // namespace penumbra
