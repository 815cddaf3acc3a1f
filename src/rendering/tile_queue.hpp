// Hands out the tiles of a picture to threads, in order: whole tiles first, quarters of tiles at the end, so that the
// threads end at about the same time.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>

#include "rendering/plan.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {

// The side of a quarter, in pixels. Quarters are counted from the top left of what a window leaves of a tile.
inline constexpr int quarter_size = tile_size / 2;

class TileQueue {
 public:
  // Of the tiles of the shard, the last two for each thread come in quarters.
  TileQueue(const TileGrid& grid, const Shard& shard, int threads)
      : grid_(grid), shard_(shard), whole_(grid.count() - in_quarters(grid, shard, threads)) {}

  // The next pixels to render; none where all are handed out. Safe to be called by several threads at once.
  std::optional<Crop> next() {
    while (true) {
      const int place = next_.fetch_add(1, std::memory_order_relaxed);
      const bool is_whole = place < whole_;
      const int tile = is_whole ? place : whole_ + (place - whole_) / 4;
      if (tile >= grid_.count()) return std::nullopt;
      if (!grid_.has(shard_, tile)) continue;
      const Crop pixels = is_whole ? grid_.tile(tile) : quarter(grid_.tile(tile), (place - whole_) % 4);
      if (pixels.width() > 0 && pixels.height() > 0) return pixels;
    }
  }

 private:
  static int in_quarters(const TileGrid& grid, const Shard& shard, int threads) {
    if (threads <= 1) return 0;
    return static_cast<int>(std::min(std::int64_t{2} * threads * shard.count, std::int64_t{grid.count()}));
  }

  static Crop quarter(const Crop& tile, int number) {
    const int x = tile.x0 + number % 2 * quarter_size, y = tile.y0 + number / 2 * quarter_size;
    return {x, y, std::min(x + quarter_size, tile.x1), std::min(y + quarter_size, tile.y1)};
  }

  const TileGrid& grid_;
  Shard shard_;
  int whole_;
  std::atomic<int> next_{0};
};

}  // namespace penumbra
