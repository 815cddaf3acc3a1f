// Tables that patterns look up instead of computing, made once for a picture.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

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

// Poisson disk points on the unit torus: no two are nearer than a given distance, and no place is farther than it from
// all points (Cook 1986, "Stochastic sampling in computer graphics"; maximal after Mitchell's farthest points, 1991).
//
// The points (u, v) of one tile, which is repeated: ((column + u) / tiles, (row + v) / tiles) for each of the
// tiles * tiles tiles. All coordinates are multiples of 2^-24 below 1. Read-only once made.
struct PoissonTable {
  std::uint32_t count = 0;  // points requested; tiles * tiles * size is at least as many
  std::uint32_t tiles = 1;  // along each side of the square
  std::uint32_t size = 0;   // points in a tile
  // On the square: the least distance between two points; no place is farther than it from its nearest point. Where
  // tiles * tiles * size exceeds `count`, up to tiles * tiles - 1 of the points are left out, and each leaves a hole.
  float distance = 0;
  std::vector<float> u, v;  // `size` of each
};

inline constexpr std::uint32_t largest_poisson_tile = 1024;

// The table for `count` points, at least 1; the same on every machine.
PoissonTable make_poisson_table(std::uint32_t count, std::uint32_t seed);

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
