// The joint dimensions of the Sobol sequence, precomputed.
#pragma once

#include <cstdint>

#include "base/zeroed_pages.hpp"
#include "sampling/pattern.hpp"

namespace penumbra {

// The first `size` points of the Owen-scrambled Sobol sequence in the joint dimensions, values[dimension * size +
// index] as 32-bit fractions. Read-only once made; shared by all threads.
struct SobolTable {
  std::uint32_t size = 0;  // a multiple of 32
  ZeroedVector<std::uint32_t> values;
};

inline constexpr std::uint32_t largest_sobol_table = 1u << 16;

// A table long enough for `count` samples per pixel, or the largest possible one, scrambled by `seed`.
SobolTable make_sobol_table(std::uint32_t count, std::uint32_t seed);

}  // namespace penumbra
