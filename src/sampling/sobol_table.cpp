// Sobol's sequence (Sobol 1967) with the direction numbers of Joe and Kuo (2008), scrambled after Owen (1995): each bit
// of a coordinate is flipped by a hash of the bits before it.
#include "sampling/sobol_table.hpp"

#include <algorithm>
#include <array>
#include <bit>

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

// Owen's nested uniform scrambling of x: every bit is flipped or not by the bits before it. One hash of the bits so far
// decides the next four: the choices are a tree of fifteen. No two of the first 2^16 points share their first sixteen
// bits, so the rest is simply random.
std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
  constexpr int shared_bits = 16, bits_of_hash = 4;
  std::uint32_t result = 0;
  for (int level = 0; level < shared_bits; level += bits_of_hash) {
    const std::uint32_t prefix = level == 0 ? 1 : (x >> (32 - level)) | (1u << level);  // a marker of how many
    const std::uint32_t choices = hash(seed, prefix);
    std::uint32_t node = 1;
    for (int bit = level; bit < level + bits_of_hash; bit++) {
      const std::uint32_t digit = (x >> (31 - bit)) & 1;
      result |= (digit ^ ((choices >> node) & 1)) << (31 - bit);
      node = 2 * node + digit;
    }
  }
  return result | (hash(seed, (x >> shared_bits) | (1u << shared_bits)) & 0xffffu);
}

}  // namespace

SobolTable make_sobol_table(std::uint32_t count, std::uint32_t seed) {
  SobolTable table;
  table.size = std::min((std::max(count, 1u) + 31) / 32 * 32, largest_sobol_table);
  table.values.resize(std::size_t{table.size} * joint_dimension_count);
  for (std::uint32_t dimension = 0; dimension < joint_dimension_count; dimension++) {
    const Directions v = direction_numbers(dimension);
    const std::uint32_t scramble_seed = hash(seed, dimension + 1);
    std::uint32_t* points = table.values.data() + std::size_t{dimension} * table.size;
    for (std::uint32_t index = 1; index < table.size; index++) {
      points[index] = points[index & (index - 1)] ^ v[static_cast<std::size_t>(std::countr_zero(index))];
    }
    for (std::uint32_t index = 0; index < table.size; index++) {
      points[index] = owen_scramble(points[index], scramble_seed);
    }
  }
  return table;
}

}  // namespace penumbra
