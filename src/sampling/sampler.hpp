// The sample points of one packet: a pure function of (pixel, index, dimension, seed) for each lane.
//
// The dimensions of an eye ray (pixel, lens, time, first light) are joint: coordinates of one Owen-scrambled Sobol
// sequence, shifted for each pixel by a hash. All later dimensions are padded: the first two Sobol dimensions again,
// their indices shuffled and their values scrambled anew for each (pixel, dimension), after Burley, "Practical
// hash-based Owen scrambling" (2020). `random` is a hash of the same arguments.
#pragma once

#include "base/hash.hpp"
#include "base/lane_math.hpp"
#include "sampling/pattern.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Numbers of [0, 1) from the upper 24 bits.
PENUMBRA_INLINE Floats to_fraction(Ints x) { return to_floats(x >> 8) * Floats(1.0f / 16777216.0f); }

PENUMBRA_INLINE Ints reverse_bits(Ints x) {
  x = ((x >> 1) & Ints(0x55555555u)) | ((x & Ints(0x55555555u)) << 1);
  x = ((x >> 2) & Ints(0x33333333u)) | ((x & Ints(0x33333333u)) << 2);
  x = ((x >> 4) & Ints(0x0f0f0f0fu)) | ((x & Ints(0x0f0f0f0fu)) << 4);
  x = ((x >> 8) & Ints(0x00ff00ffu)) | ((x & Ints(0x00ff00ffu)) << 8);
  return (x >> 16) | (x << 16);
}

// A permutation of words in which every bit depends on the bits below it only: nested uniform scrambling of the
// bit-reversed word (Laine and Karras 2011 with the constants of Vegdahl 2021).
PENUMBRA_INLINE Ints scramble_upward(Ints x, Ints seed) {
  x ^= x * Ints(0x3d20adeau);
  x += seed;
  x *= (seed >> 16) | Ints(1);
  x ^= x * Ints(0x05526c56u);
  x ^= x * Ints(0x53a22864u);
  return x;
}

// An order of the indices in which every bit depends on the bits above it: aligned blocks of 2^k indices stay together,
// so that they stay nets. Without it the first bits of all padded dimensions would be one and the same bit of the
// index.
PENUMBRA_INLINE Ints shuffle(Ints index, Ints seed) { return reverse_bits(scramble_upward(reverse_bits(index), seed)); }

// The second Sobol dimension of an index, bit-reversed on both sides: Pascal's triangle modulo 2 as five butterflies.
PENUMBRA_INLINE Ints second_sobol_dimension(Ints x) {
  x ^= (x & Ints(0xaaaaaaaau)) >> 1;
  x ^= (x & Ints(0xccccccccu)) >> 2;
  x ^= (x & Ints(0xf0f0f0f0u)) >> 4;
  x ^= (x & Ints(0xff00ff00u)) >> 8;
  x ^= (x & Ints(0xffff0000u)) >> 16;
  return x;
}

struct Pair {
  Floats u, v;
};

// What stays the same for all samples of the pixels of a packet.
struct PixelSampler {
  Ints key;  // one hash for each pixel, the seed mixed in
  Ints joint_shift[joint_dimension_count];

  PENUMBRA_INLINE PixelSampler(Ints column, Ints row, std::uint32_t seed) : key(hash(hash(column, row), Ints(seed))) {
    for (std::uint32_t d = 0; d < joint_dimension_count; d++) joint_shift[d] = hash(key, Ints(d));
  }
};

struct Sampler {
  Pattern pattern;
  const SobolTable* table;
  const PixelSampler* pixel;
  Ints key;                   // of the pixel, and of the block of 65536 samples
  Ints index;                 // of the sample in its pixel
  std::uint32_t first_index;  // of lane 0
  bool consecutive;           // lane k has index first_index + k

  // `samples_per_pixel` lanes belong to one pixel: their indices start at `first`, a multiple of it.
  PENUMBRA_INLINE Sampler(Pattern p, const SobolTable* sobol, const PixelSampler& pixel_sampler, std::uint32_t first,
                          int samples_per_pixel)
      : pattern(p),
        table(sobol),
        pixel(&pixel_sampler),
        key(pixel_sampler.key),
        index((lane_numbers() & Ints(static_cast<std::uint32_t>(samples_per_pixel - 1))) + Ints(first)),
        first_index(first),
        consecutive(samples_per_pixel == lane_count) {
    if (first >= largest_sobol_table) key = hash(key, Ints(first / largest_sobol_table));
  }

  // A dimension of the eye ray, in [0, 1).
  PENUMBRA_INLINE Floats joint(JointDimension dimension) const {
    if (pattern == Pattern::random) return to_fraction(hash(pixel->joint_shift[dimension], index));
    const std::uint32_t* points = table->values.data() + std::size_t{dimension} * table->size;
    const Ints shift = first_index < largest_sobol_table ? pixel->joint_shift[dimension] : hash(key, Ints(dimension));
    const Ints point = consecutive ? load(points + (first_index & (largest_sobol_table - 1)))
                                   : gather(points, index & Ints(largest_sobol_table - 1));
    return to_fraction(point ^ shift);
  }

  // Two later dimensions, together a two-dimensional stratified pattern. `dimension` is a hash that names them.
  PENUMBRA_INLINE Pair pair(std::uint32_t dimension) const {
    const Ints seed = hash(key, Ints(dimension));
    const Ints other_seed = mix_bits(seed + Ints(0x68bc21ebu));
    if (pattern == Pattern::random) return {to_fraction(hash(seed, index)), to_fraction(hash(other_seed, index))};
    const Ints shuffled = shuffle(index, seed);
    const Ints first = scramble_upward(shuffled, mix_bits(seed ^ Ints(0x02e5be93u)));
    const Ints second = scramble_upward(second_sobol_dimension(shuffled), other_seed);
    return {to_fraction(reverse_bits(first) ^ mix_bits(other_seed ^ Ints(0x02e5be93u))),
            to_fraction(reverse_bits(second) ^ mix_bits(other_seed ^ Ints(0x967a889bu)))};
  }

  // One later dimension.
  PENUMBRA_INLINE Floats single(std::uint32_t dimension) const {
    const Ints seed = hash(key, Ints(dimension));
    if (pattern == Pattern::random) return to_fraction(hash(seed, index));
    const Ints other_seed = mix_bits(seed ^ Ints(0x02e5be93u));
    return to_fraction(reverse_bits(scramble_upward(shuffle(index, seed), other_seed)) ^ other_seed);
  }
};

}  // namespace penumbra::PENUMBRA_KERNEL
