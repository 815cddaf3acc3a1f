// The sample points of rays that are alone, each at its own place in the tree of its own sample: far from the eye,
// where all patterns but `random` draw scrambled Sobol points.
#pragma once

#include "sampling/random.hpp"
#include "sampling/regular.hpp"
#include "sampling/sobol.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct LoneSampler {
  Ints key, index;  // of the pixel, and of the sample in it
  std::uint32_t count;
  bool random;  // the pattern is

  // Dimensions that hashes name, in [0, 1).
  PENUMBRA_INLINE Pair pair(Ints dimension) const {
    const Ints first = hash(key, dimension), second = mix_bits(first + Ints(0x68bc21ebu));
    return random ? random_pair(first, second, index) : sobol_pair(first, second, index);
  }
  PENUMBRA_INLINE Floats single(Ints dimension) const {
    const Ints k = hash(key, dimension);
    return random ? random_single(k, index) : sobol_single(k, index);
  }
  // Two dimensions of the fixed regular pattern.
  Pair regular(Ints dimension) const {
    const Ints points(count);
    return regular_pair(index - divide(index, points) * points, count, dimension);
  }
};

}  // namespace penumbra::PENUMBRA_KERNEL
