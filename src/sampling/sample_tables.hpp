// What patterns look up instead of computing, made once for a picture.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "sampling/poisson_table.hpp"
#include "sampling/sobol_table.hpp"

namespace penumbra {

struct SampleTables {
  SobolTable sobol;
  std::vector<PoissonTable> poisson;  // one for each count that is asked for
};

// The pattern of a picture and what belongs to it.
struct PatternChoice {
  Pattern pattern;
  std::uint32_t count;  // samples of a pixel
  std::uint32_t seed;
  const SampleTables* tables;
};

// The tables that `pattern` needs for sets of these many points, the first being the rays of a pixel.
SampleTables make_sample_tables(Pattern pattern, std::initializer_list<std::uint32_t> counts, std::uint32_t seed);

}  // namespace penumbra
