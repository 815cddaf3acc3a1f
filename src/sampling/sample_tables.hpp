// Tables that patterns look up instead of computing, made once for a picture.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "sampling/poisson_table.hpp"
#include "sampling/sobol_table.hpp"

namespace penumbra {

struct SampleTables {
  SobolTable sobol;
  std::vector<PoissonTable> poisson;  // one for each count in use
};

// The pattern of a picture and its parameters.
struct PatternChoice {
  Pattern pattern;
  std::uint32_t count;  // samples per pixel
  std::uint32_t seed;
  const SampleTables* tables;
};

// The tables that `pattern` needs for point sets of these sizes; the first is the number of rays per pixel.
SampleTables make_sample_tables(Pattern pattern, std::initializer_list<std::uint32_t> counts, std::uint32_t seed);

}  // namespace penumbra
