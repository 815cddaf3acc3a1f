// `jittered`: one point anywhere in each of `count` cells of equal area (pages 5 to 9 of the lecture; Cook, Porter,
// Carpenter 1984). Each dimension takes its cells in its own random order, as Cook proposed.
#pragma once

#include "sampling/permutation.hpp"
#include "sampling/random.hpp"
#include "sampling/strata.hpp"

namespace penumbra::PENUMBRA_KERNEL {

inline Pair jittered_pair(Ints key, Ints other_key, Ints index, std::uint32_t count) {
  const Strata strata(count);
  return place_in(strata, stratum_at(strata, permute(index, count, mix_bits(key ^ Ints(0x3c6ef372u)))),
                  random_pair(key, other_key, index));
}

inline Floats jittered_single(Ints key, Ints index, std::uint32_t count) {
  return place_on_line(count, permute(index, count, mix_bits(key ^ Ints(0x3c6ef372u))), random_single(key, index));
}

}  // namespace penumbra::PENUMBRA_KERNEL
