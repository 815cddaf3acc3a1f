// `poisson`: the points of a Poisson disk table (Cook 1986), shifted, mirrored and transposed as a whole and put in a
// random order for each pixel and dimension. The square wraps around, so none of this changes a distance.
#pragma once

#include "sampling/permutation.hpp"
#include "sampling/sample_tables.hpp"
#include "sampling/strata.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The integer part of x / b for x < 2^26. Below 2^24 the quotient of floats is exact enough; above, it can be off by
// one in either direction, which is corrected.
PENUMBRA_INLINE Ints divide_large(Ints x, std::uint32_t b) {
  const Ints quotient = truncate(to_floats(x) / Floats(static_cast<float>(b)));
  const Ints rest = x - quotient * Ints(b);
  const Ints fewer = select(rest < Ints(0x80000000u), quotient, quotient - Ints(1));
  return select((rest < Ints(0x80000000u)) & ~(rest < Ints(b)), quotient + Ints(1), fewer);
}

// Point `index` of the pixel and dimension that `key` names.
inline Pair poisson_pair(const PoissonTable& table, Ints key, Ints index) {
  const std::uint32_t total = table.tiles * table.tiles * table.size;
  const Ints symmetry = mix_bits(key ^ Ints(0x6a09e667u));
  const Ints shift_u = mix_bits(key ^ Ints(0xbb67ae85u)), shift_v = mix_bits(key ^ Ints(0x3c6ef372u));
  Ints place = permute(index, total, mix_bits(key ^ Ints(0xa54ff53au)));
  place = select(place < Ints(total), place, Ints(0));
  Ints tile(0);
  if (table.tiles > 1) {
    tile = divide_large(place, table.size);
    place = place - tile * Ints(table.size);
  }
  Floats u = gather(table.u.data(), place), v = gather(table.v.data(), place);
  if (table.tiles > 1) {
    const Floats tiles(static_cast<float>(table.tiles));
    const Ints row = divide(tile, Ints(table.tiles));
    u = (to_floats(tile - row * Ints(table.tiles)) + u) / tiles;
    v = (to_floats(row) + v) / tiles;
  }
  // On the grid of 2^-24, shifting and mirroring are exact.
  const Floats steps(16777216.0f);
  Ints x = truncate(u * steps), y = truncate(v * steps);
  x = select((symmetry & Ints(1)) == Ints(0), x, Ints(0) - x);
  y = select((symmetry & Ints(2)) == Ints(0), y, Ints(0) - y);
  const Mask turned = (symmetry & Ints(4)) == Ints(4);
  const Ints first = select(turned, y, x) + (shift_u >> 8), second = select(turned, x, y) + (shift_v >> 8);
  return {to_fraction(first << 8), to_fraction(second << 8)};
}

// On a circle: one point in each stratum, in random order, at most a sixth of a stratum from its middle, all rotated by
// the same angle. No two points are nearer than 2/3 of a stratum, and no gap is wider than 4/3.
inline Floats poisson_single(std::uint32_t count, Ints key, Ints index) {
  const Ints turn = mix_bits(key ^ Ints(0x510e527fu));
  const Ints stratum = permute(index, count, mix_bits(key ^ Ints(0x9b05688cu)));
  const Floats jitter = (Floats(1) + to_fraction(hash(key, index))) * Floats(1.0f / 3.0f);
  const Floats place = place_on_line(count, stratum, jitter);
  return to_fraction((truncate(place * Floats(16777216.0f)) + (turn >> 8)) << 8);
}

}  // namespace penumbra::PENUMBRA_KERNEL
