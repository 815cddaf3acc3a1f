// `halton`: van der Corput's sequences in different prime bases (Halton 1960), each scrambled by Owen's nested method:
// every digit is permuted, the permutation chosen by the digits before it. The permutations are d -> a d + s (mod
// base): of any two digits every pair of images is equally likely, which is all that the variance depends on (Owen
// 1995).
//
// The place in the pixel has the bases 2 and 3, the time has base 5. Larger bases need more points than a pixel has
// before they are better than random ones, so all other pairs have the bases 2 and 3 again, their indices shuffled anew
// for each dimension.
#pragma once

#include "sampling/owen.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// The digits of `index` in the base, mirrored at the point and scrambled; as many as 24 bits can hold.
template <std::uint32_t base>
inline Floats scrambled_radical_inverse(Ints index, Ints key) {
  Ints digits(0);
  Ints node = key;
  double scale = 1;
  while (scale < 16777216.0) {
    // Two divisions, each below 2^24: the upper and the lower half of the word.
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

// Where in the pixel: bases 2 and 3.
inline Pair halton_pixel(Ints key, Ints other_key, Ints index) {
  return {scrambled_van_der_corput(index, key), scrambled_radical_inverse<3>(index, other_key)};
}

// When: base 5.
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
