// A picture shared out among several runs of the program: each has its own tiles, spread all over the picture so that
// the work is even.
#pragma once

#include <cstdint>

namespace penumbra {

inline constexpr int most_shards = 1'000'000;

// Shard `index` of `count`, from 0.
struct Shard {
  int index = 0, count = 1;

  // Whether it has the tile in this column and row of the picture. In a row, every `count`-th tile is its own; from row
  // to row, it begins a golden section of `count` farther. So its tiles are a lattice without a preferred direction,
  // and every part of the picture has as many of them.
  bool has(int column, int row) const {
    if (count == 1) return true;
    const std::uint64_t section = std::uint64_t{static_cast<std::uint32_t>(row) * 0x9e3779b9u};  // 2^32 is one
    const std::uint64_t shift = section * static_cast<std::uint64_t>(count) >> 32;
    const std::uint64_t owner = (static_cast<std::uint64_t>(column) + shift) % static_cast<std::uint64_t>(count);
    return owner == static_cast<std::uint64_t>(index);
  }

  bool operator==(const Shard&) const = default;
};

}  // namespace penumbra
