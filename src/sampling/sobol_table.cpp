// Sobol's sequence (Sobol 1967) with the direction numbers of Joe and Kuo (2008), scrambled after Owen (1995): each bit
// of a coordinate is flipped by a hash of the bits before it.
#include "sampling/sobol_table.hpp"

#include <algorithm>
#include <array>

#include "base/hash.hpp"

namespace penumbra {
namespace {

// Degree, coefficients and initial numbers of the primitive polynomials for dimensions 2 to 7 (new-joe-kuo-6).
struct Polynomial {
  int degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 4> initial;
};
constexpr std::array<Polynomial, joint_dimension_count - 1> polynomials{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
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

// Owen's nested uniform scrambling of the 32 bits of x.
std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
  std::uint32_t flips = hash(seed, 0u) & 0x80000000u;
  for (int bit = 1; bit < 32; bit++) {
    const std::uint32_t prefix = (x >> (32 - bit)) | (1u << bit);  // the bits before, with a marker of how many
    flips |= (hash(seed, prefix) & 1u) << (31 - bit);
  }
  return x ^ flips;
}

}  // namespace

SobolTable make_sobol_table(std::uint32_t count, std::uint32_t seed) {
  SobolTable table;
  table.size = std::min((std::max(count, 1u) + 15) / 16 * 16, largest_sobol_table);
  table.values.resize(std::size_t{table.size} * joint_dimension_count);
  for (std::uint32_t dimension = 0; dimension < joint_dimension_count; dimension++) {
    const Directions v = direction_numbers(dimension);
    const std::uint32_t scramble_seed = hash(seed, dimension + 1);
    for (std::uint32_t index = 0; index < table.size; index++) {
      std::uint32_t x = 0;
      for (int bit = 0; index >> bit != 0; bit++) {
        if ((index >> bit) & 1) x ^= v[bit];
      }
      table.values[std::size_t{dimension} * table.size + index] = owen_scramble(x, scramble_seed);
    }
  }
  return table;
}

}  // namespace penumbra
