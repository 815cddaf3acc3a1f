// The permutations of the packets, for lists of any length.
#pragma once

#include <cstdint>
#include <vector>

namespace penumbra::test {

// Where each index goes in the permutation of 0 .. length-1 named by the key at the same place.
std::vector<std::uint32_t> permuted(std::vector<std::uint32_t> index, std::uint32_t length,
                                    std::vector<std::uint32_t> key);

}  // namespace penumbra::test
