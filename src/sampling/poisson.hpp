#pragma once
#include "sampling/poisson_table.hpp"
#include "sampling/random.hpp"
namespace penumbra::PENUMBRA_KERNEL {
inline Pair poisson_pair(const PoissonTable&, Ints key, Ints index) { return random_pair(key, mix_bits(key), index); }
inline Floats poisson_single(std::uint32_t, Ints key, Ints index) { return random_single(key, index); }
}  // namespace penumbra::PENUMBRA_KERNEL
