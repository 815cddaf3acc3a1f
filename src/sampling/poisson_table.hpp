// Poisson disk points on the unit torus: no two nearer than a distance, and no place farther from all of them than it
// (Cook 1986, "Stochastic sampling in computer graphics"; maximality after Mitchell's farthest points, 1991).
#pragma once

#include <cstdint>
#include <vector>

namespace penumbra {

// Points of one tile, and how many tiles there are: place (column + u) / tiles, (row + v) / tiles for each of the
// tiles * tiles tiles. All coordinates are whole multiples of 2^-24, below 1. Read only once made.
struct PoissonTable {
  std::uint32_t count = 0;  // points asked for; tiles * tiles * size is at least that many
  std::uint32_t tiles = 1;  // along each side of the square
  std::uint32_t size = 0;   // points of a tile
  // On the square: the least between two points, and the greatest from a place to a point. Where tiles * tiles * size
  // is more than `count`, up to tiles * tiles - 1 of the points are left out, each of which leaves a hole.
  float distance = 0;
  std::vector<float> u, v;  // `size` of each
};

inline constexpr std::uint32_t largest_poisson_tile = 1024;

// The table of `count` points, at least 1; the same on every machine.
PoissonTable make_poisson_table(std::uint32_t count, std::uint32_t seed);

}  // namespace penumbra
