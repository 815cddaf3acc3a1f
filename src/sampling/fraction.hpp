// Maps words to numbers in [0, 1); the integer arithmetic that the patterns share.
#pragma once

#include "base/hash.hpp"
#include "base/lane_math.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Pair {
  Floats u, v;
};

// Numbers in [0, 1) from the upper 24 bits.
PENUMBRA_INLINE Floats to_fraction(Ints x) { return to_floats(x >> 8) * Floats(1.0f / 16777216.0f); }

// Puts numbers that rounding raised to 1 back below it.
PENUMBRA_INLINE Floats below_one(Floats x) { return min(x, Floats(0.99999994f)); }

// The integer part of a / b for a < 2^24 and b > 0, where a single-precision quotient never rounds up to the next
// integer.
PENUMBRA_INLINE Ints divide(Ints a, Ints b) { return truncate(to_floats(a) / to_floats(b)); }

// An integer in 0..length-1 from the upper 24 bits of x; length <= 2^24.
PENUMBRA_INLINE Ints pick(Ints x, Ints length) { return truncate(to_fraction(x) * to_floats(length)); }

// Reverses the bits of each word: looks up the two halves of every byte, then reverses the bytes.
PENUMBRA_INLINE Ints reverse_bits(Ints x) {
  const Ints low = pick_bytes(sixteen_bytes(0xc0408000u, 0xe060a020u, 0xd0509010u, 0xf070b030u), x & Ints(0x0f0f0f0fu));
  const Ints high =
      pick_bytes(sixteen_bytes(0x0c040800u, 0x0e060a02u, 0x0d050901u, 0x0f070b03u), (x >> 4) & Ints(0x0f0f0f0fu));
  return pick_bytes(low | high, sixteen_bytes(0x00010203u, 0x04050607u, 0x08090a0bu, 0x0c0d0e0fu));
}

}  // namespace penumbra::PENUMBRA_KERNEL
