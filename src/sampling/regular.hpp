// `regular`: the centres of equal cells, the same in every pixel and for every seed. It aliases, and shows what the
// lecture means by "too distinct". The grid in the pixel is in scan order; every other dimension takes its cells in its
// own fixed shuffled order, because otherwise all effects of a ray would be correlated.
#pragma once

#include "sampling/permutation.hpp"
#include "sampling/strata.hpp"

namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Ints regular_order(Ints index, std::uint32_t count, std::uint32_t dimension) {
  return dimension == pixel_x ? index : permute(index, count, Ints(hash(dimension, 0x51ed270bu)));
}

PENUMBRA_INLINE Ints regular_order(Ints index, std::uint32_t count, Ints dimension) {
  return permute(index, count, hash(dimension, Ints(0x51ed270bu)));
}

template <typename Word>
inline Pair regular_pair(Ints index, std::uint32_t count, Word dimension) {
  const Strata strata(count);
  return place_in(strata, stratum_at(strata, regular_order(index, count, dimension)), {Floats(0.5f), Floats(0.5f)});
}

inline Floats regular_single(Ints index, std::uint32_t count, std::uint32_t dimension) {
  return place_on_line(count, regular_order(index, count, dimension), Floats(0.5f));
}

}  // namespace penumbra::PENUMBRA_KERNEL
