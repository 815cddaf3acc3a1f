// Poisson disk points on the unit torus: no two are nearer than a given distance, and no place is farther than it from
// all points (Cook 1986, "Stochastic sampling in computer graphics"; maximal after Mitchell's farthest points, 1991).
#pragma once

#include <cstdint>
#include <vector>

namespace penumbra {

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

}  // namespace penumbra
