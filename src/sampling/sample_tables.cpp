#include "sampling/sample_tables.hpp"

#include <algorithm>

namespace penumbra {

SampleTables make_sample_tables(Pattern pattern, std::initializer_list<std::uint32_t> counts, std::uint32_t seed) {
  SampleTables tables;
  if (pattern == Pattern::sobol) tables.sobol = make_sobol_table(*counts.begin(), seed);
  if (pattern == Pattern::poisson) {
    for (const std::uint32_t count : counts) {
      const auto made = std::any_of(tables.poisson.begin(), tables.poisson.end(),
                                    [count](const PoissonTable& table) { return table.count == count; });
      if (!made) tables.poisson.push_back(make_poisson_table(count, seed));
    }
  }
  return tables;
}

}  // namespace penumbra
