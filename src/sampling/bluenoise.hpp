#pragma once
#include "sampling/random.hpp"
#include "sampling/sobol_table.hpp"
namespace penumbra::PENUMBRA_KERNEL {
inline Pair bluenoise_pair(const SobolTable&, Ints c, Ints r, Ints index, std::uint32_t d, std::uint32_t seed) {
  Ints k = hash(hash(c, r), Ints(seed + d));
  return random_pair(k, mix_bits(k), index);
}
inline Floats bluenoise_single(const SobolTable&, Ints c, Ints r, Ints index, std::uint32_t d, std::uint32_t seed) {
  Ints k = hash(hash(c, r), Ints(seed + d));
  return random_single(k, index);
}
}  // namespace penumbra::PENUMBRA_KERNEL
