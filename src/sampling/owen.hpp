// Nested uniform scrambling (Owen 1995) without tables, after Burley, "Practical hash-based Owen scrambling" (2020).
#pragma once

#include "sampling/fraction.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// A permutation of words in which every bit depends only on the bits below it: nested uniform scrambling of the
// bit-reversed word (Laine and Karras 2011 with the constants of Vegdahl 2021). The seed may be one word for all lanes.
template <typename Word>
PENUMBRA_INLINE Ints scramble_upward(Ints x, Word seed) {
  x ^= x * Ints(0x3d20adeau);
  x += Ints(seed);
  x *= Ints((seed >> 16) | Word(1));
  x ^= x * Ints(0x05526c56u);
  x ^= x * Ints(0x53a22864u);
  return x;
}

// A permutation of the indices in which every bit depends only on the bits above it: aligned blocks of 2^k indices stay
// together and so remain nets. Without it, the first bit of every padded dimension would be the same bit of the index.
template <typename Word>
PENUMBRA_INLINE Ints shuffle(Ints index, Word seed) {
  return reverse_bits(scramble_upward(reverse_bits(index), seed));
}

// Van der Corput's sequence in base 2, scrambled.
template <typename Word>
PENUMBRA_INLINE Floats scrambled_van_der_corput(Ints index, Word seed) {
  return to_fraction(reverse_bits(scramble_upward(index, seed)) ^ Ints(seed));
}

}  // namespace penumbra::PENUMBRA_KERNEL
