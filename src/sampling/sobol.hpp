// `sobol`: the dimensions of an eye ray (pixel, lens, first light, time) are coordinates of one Owen-scrambled Sobol
// sequence, shifted for each pixel by a hash. Later dimensions are padded: they use the first two Sobol dimensions
// again, with indices shuffled and values scrambled separately for each (pixel, dimension), after Burley, "Practical
// hash-based Owen scrambling" (2020).
#pragma once

#include "sampling/owen.hpp"
#include "sampling/sample_tables.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The second Sobol dimension of an index, bit-reversed: Pascal's triangle modulo 2 as five butterflies.
PENUMBRA_INLINE Ints second_sobol_dimension(Ints x) {
  x ^= (x & Ints(0xaaaaaaaau)) >> 1;
  x ^= (x & Ints(0xccccccccu)) >> 2;
  x ^= (x & Ints(0xf0f0f0f0u)) >> 4;
  x ^= (x & Ints(0xff00ff00u)) >> 8;
  x ^= (x & Ints(0xffff0000u)) >> 16;
  return x;
}

// Two later dimensions, together a (0,2)-sequence. Each key may be one word for all lanes.
template <typename Word>
PENUMBRA_INLINE Pair sobol_pair(Word key, Word other_key, Ints index) {
  const Ints shuffled = shuffle(index, key);
  const Ints first = scramble_upward(shuffled, mix_bits(key ^ Word(0x02e5be93u)));
  const Ints second = scramble_upward(second_sobol_dimension(shuffled), other_key);
  return {to_fraction(reverse_bits(first) ^ Ints(mix_bits(other_key ^ Word(0x02e5be93u)))),
          to_fraction(reverse_bits(second) ^ Ints(mix_bits(other_key ^ Word(0x967a889bu))))};
}

// One later dimension.
template <typename Word>
PENUMBRA_INLINE Floats sobol_single(Word key, Ints index) {
  return scrambled_van_der_corput(shuffle(index, key), mix_bits(key ^ Word(0x02e5be93u)));
}

}  // namespace penumbra::PENUMBRA_KERNEL
