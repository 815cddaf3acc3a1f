// A picture divided among several runs of the program: each renders its own tiles, spread all over the picture so that
// the work is even.
#pragma once

#include <cstdint>

namespace penumbra {

inline constexpr int most_shards = 1'000'000;

// Shard `index` of `count`, counted from 0.
struct Shard {
  int index = 0, count = 1;

  // Whether it has the tile in this column and row of the picture. In a row, it has every `count`-th tile; from row to
  // row, its first tile moves by the golden section of `count`. So its tiles form a lattice without a preferred
  // direction, with equally many tiles in every part of the picture.
  bool has(int column, int row) const {
    if (count == 1) return true;
    const std::uint64_t section = std::uint64_t{static_cast<std::uint32_t>(row) * 0x9e3779b9u};  // in units of 2^-32
    const std::uint64_t shift = section * static_cast<std::uint64_t>(count) >> 32;
    const std::uint64_t owner = (static_cast<std::uint64_t>(column) + shift) % static_cast<std::uint64_t>(count);
    return owner == static_cast<std::uint64_t>(index);
  }

  bool operator==(const Shard&) const = default;
};

}  // namespace penumbra
