#pragma once
#include <cstdint>
#include <vector>
namespace penumbra {
struct PoissonTable {
  std::uint32_t count;
  float distance;
  std::vector<float> u, v;
};
PoissonTable make_poisson_table(std::uint32_t count, std::uint32_t seed);
}  // namespace penumbra
