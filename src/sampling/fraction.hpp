// From words to numbers of [0, 1), and the whole-number arithmetic that patterns share.
#pragma once

#include "base/hash.hpp"
#include "base/lane_math.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Pair {
  Floats u, v;
};

// Numbers of [0, 1) from the upper 24 bits.
PENUMBRA_INLINE Floats to_fraction(Ints x) { return to_floats(x >> 8) * Floats(1.0f / 16777216.0f); }

// What rounding brought up to 1 goes back below it.
PENUMBRA_INLINE Floats below_one(Floats x) { return min(x, Floats(0.99999994f)); }

// The whole part of a / b for a < 2^24 and b > 0: a quotient in single precision is never rounded up to the next whole
// number.
PENUMBRA_INLINE Ints divide(Ints a, Ints b) { return truncate(to_floats(a) / to_floats(b)); }

// A whole number of 0..length-1 from the upper 24 bits of x; length <= 2^24.
PENUMBRA_INLINE Ints pick(Ints x, Ints length) { return truncate(to_fraction(x) * to_floats(length)); }

PENUMBRA_INLINE Ints reverse_bits(Ints x) {
  x = ((x >> 1) & Ints(0x55555555u)) | ((x & Ints(0x55555555u)) << 1);
  x = ((x >> 2) & Ints(0x33333333u)) | ((x & Ints(0x33333333u)) << 2);
  x = ((x >> 4) & Ints(0x0f0f0f0fu)) | ((x & Ints(0x0f0f0f0fu)) << 4);
  x = ((x >> 8) & Ints(0x00ff00ffu)) | ((x & Ints(0x00ff00ffu)) << 8);
  return (x >> 16) | (x << 16);
}

}  // namespace penumbra::PENUMBRA_KERNEL
