// Random permutations as functions: where an index goes, without storing the list. Up to length 16, the indices are
// sorted by random numbers, which makes all orders equally likely. For longer lists, the index passes through a keyed
// bijection of k-bit words, 2^k being the next power of two, again and again until it is below the length ("cycle
// walking", after Kensler, "Correlated multi-jittered sampling", 2013; the mixing is our own).
#pragma once

#include <bit>

#include "base/hash.hpp"
#include "base/lanes.hpp"

namespace penumbra::PENUMBRA_KERNEL {

inline constexpr std::uint32_t largest_permutation = 1u << 26;
inline constexpr std::uint32_t largest_sorted_permutation = 16;

// The rank of the index among `length` indices sorted by their hashes.
PENUMBRA_INLINE Ints permute_by_sorting(Ints index, std::uint32_t length, Ints key) {
  const Ints start = mix_bits(key + Ints(0x5bd1e995u));
  const Ints own = mix_bits(start + index * Ints(0x9e3779b9u));
  Ints place(0);
  for (std::uint32_t other = 0; other < length; other++) {
    const Ints value = mix_bits(start + Ints(other * 0x9e3779b9u));  // all different: mixing is a bijection
    place = select(value < own, place + Ints(1), place);
  }
  return place;
}

inline constexpr int word_rounds = 8;

// A bijection of words of `bits` bits (5 to 26).
PENUMBRA_INLINE Ints permute_words(Ints word, int bits, Ints key) {
  const Ints mask((1u << bits) - 1);
  const int half = (bits - 1) / 2;
  for (int round = 0; round < word_rounds; round++) {
    key = mix_bits(key + Ints(0x9e3779b9u));
    word = ((word ^ key) * ((key >> 16) | Ints(1))) & mask;
    word ^= word >> half;
  }
  return (word + key) & mask;
}

// Where the index (below `length`) goes in the permutation of 0..length-1 that the key names; length is at most
// largest_permutation. An index out of range, as in an inactive lane, gives an arbitrary result.
PENUMBRA_INLINE Ints permute(Ints index, std::uint32_t length, Ints key) {
  if (length <= largest_sorted_permutation) return permute_by_sorting(index, length, key);
  const int bits = 32 - std::countl_zero(length - 1);
  Ints word = permute_words(index, bits, key);
  const Mask valid = index < Ints(length);
  Mask outside = valid & ~(word < Ints(length));
  while (any(outside)) {
    word = select(outside, permute_words(word, bits, key), word);
    outside = outside & ~(word < Ints(length));
  }
  return word;
}

}  // namespace penumbra::PENUMBRA_KERNEL
