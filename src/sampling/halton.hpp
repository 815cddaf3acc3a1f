// `halton`: van der Corput's sequences in different prime bases (Halton 1960), with Owen's nested scrambling: every
// digit is permuted by a permutation that depends on the digits before it. The permutations are d -> a d + s
// (mod base), under which all pairs of images of two digits are equally likely; the variance depends on nothing else
// (Owen 1995).
//
// The position in the pixel uses bases 2 and 3, the time base 5. Larger bases beat random points only with more points
// than a pixel has, so all other pairs use bases 2 and 3 again, with indices shuffled separately for each dimension.
#pragma once

#include "sampling/owen.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The digits of `index` in the base, mirrored at the radix point and scrambled; as many as 24 bits hold.
template <std::uint32_t base>
inline Floats scrambled_radical_inverse(Ints index, Ints key) {
  Ints digits(0);
  Ints node = key;
  double scale = 1;
  while (scale < 16777216.0) {
    // Two divisions, of the upper and the lower half of the word, so that each dividend is below 2^24.
    const Ints upper = divide(index >> 16, Ints(base));
    const Ints rest = (((index >> 16) - upper * Ints(base)) << 16) | (index & Ints(0xffffu));
    const Ints lower = divide(rest, Ints(base));
    const Ints digit = rest - lower * Ints(base);
    index = (upper << 16) + lower;
    node = mix_bits(node);
    const Ints factor = (((node & Ints(0xffffu)) * Ints(base - 1)) >> 16) + Ints(1);
    const Ints shift = ((node >> 16) * Ints(base)) >> 16;
    const Ints image = factor * digit + shift;
    const Ints scrambled = image - divide(image, Ints(base)) * Ints(base);
    digits = digits * Ints(base) + scrambled;
    node = node + digit + Ints(1);
    scale *= base;
  }
  return below_one(to_floats(digits) * Floats(static_cast<float>(1 / scale)));
}

// The position in the pixel: bases 2 and 3.
inline Pair halton_pixel(Ints key, Ints other_key, Ints index) {
  return {scrambled_van_der_corput(index, key), scrambled_radical_inverse<3>(index, other_key)};
}

// The time: base 5.
inline Floats halton_time(Ints key, Ints index) { return scrambled_radical_inverse<5>(index, key); }

// Two later dimensions.
inline Pair halton_pair(Ints key, Ints other_key, Ints index) {
  const Ints shuffled = shuffle(index, key);
  return {scrambled_van_der_corput(shuffled, mix_bits(key ^ Ints(0x02e5be93u))),
          scrambled_radical_inverse<3>(shuffled, other_key)};
}

// One later dimension.
inline Floats halton_single(Ints key, Ints index) {
  return scrambled_van_der_corput(shuffle(index, key), mix_bits(key ^ Ints(0x02e5be93u)));
}

}  // namespace penumbra::PENUMBRA_KERNEL
