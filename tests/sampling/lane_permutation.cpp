// Compiled with the lanes of SSE4.2, which every machine that runs the program has.
#include "sampling/lane_permutation.hpp"

#include "sampling/permutation.hpp"

namespace penumbra::test {

std::vector<std::uint32_t> permuted(std::vector<std::uint32_t> index, std::uint32_t length,
                                    std::vector<std::uint32_t> key) {
  using namespace PENUMBRA_KERNEL;
  const std::size_t size = index.size(), whole = (size + lane_count - 1) / lane_count * lane_count;
  index.resize(whole);
  key.resize(whole);
  for (std::size_t i = 0; i < whole; i += lane_count) {
    store(index.data() + i, permute(load(index.data() + i), length, load(key.data() + i)));
  }
  index.resize(size);
  return index;
}

}  // namespace penumbra::test
