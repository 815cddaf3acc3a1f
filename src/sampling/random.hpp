// `random`: independent points, the lecture's noise without any order. Each number is a hash of all that names it.
#pragma once

#include "sampling/fraction.hpp"

namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Floats random_single(Ints key, Ints index) { return to_fraction(hash(key, index)); }

PENUMBRA_INLINE Pair random_pair(Ints key, Ints other_key, Ints index) {
  return {random_single(key, index), random_single(other_key, index)};
}

}  // namespace penumbra::PENUMBRA_KERNEL
