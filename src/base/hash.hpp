// Hashing of 32-bit words, for plain integers and lanes alike.
#pragma once

#include <cstdint>

namespace penumbra {

// A bijection of 32-bit words in which every output bit depends on every input bit ("lowbias32", C. Wellons, 2018).
template <typename Word>
inline __attribute__((always_inline)) Word mix_bits(Word x) {
  x = x ^ (x >> 16);
  x = x * Word(0x7feb352du);
  x = x ^ (x >> 15);
  x = x * Word(0x846ca68bu);
  return x ^ (x >> 16);
}

// The hash of a sequence of two words.
template <typename Word>
inline __attribute__((always_inline)) Word hash(Word a, Word b) {
  return mix_bits(mix_bits(a + Word(0x9e3779b9u)) ^ (b * Word(0x85ebca6bu) + Word(0xc2b2ae35u)));
}

}  // namespace penumbra
