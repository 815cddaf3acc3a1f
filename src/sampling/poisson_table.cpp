#include "sampling/poisson_table.hpp"
namespace penumbra {
PoissonTable make_poisson_table(std::uint32_t count, std::uint32_t) { return {count, 0, {}, {}}; }
}  // namespace penumbra
