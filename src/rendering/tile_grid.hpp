// The tiles of a picture: squares that start at its top left and are cut to a window of it. They are numbered row by
// row.
#pragma once

#include <cstdint>

#include "rendering/plan.hpp"

namespace penumbra {

// Pixels per side: so few that the tiles of each thread and of each shard add up to about the same work.
inline constexpr int tile_size = 8;
// For renders in which each pixel has its own number of samples, and a tile uses some pixels around it.
inline constexpr int noise_tile_size = 16;

class TileGrid {
 public:
  explicit TileGrid(const PixelRect& window, int size = tile_size)
      : window_(window),
        size_(size),
        left_(window.x0 / size),
        top_(window.y0 / size),
        columns_((window.x1 + size - 1) / size - left_),
        rows_((window.y1 + size - 1) / size - top_) {}

  const PixelRect& window() const { return window_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int count() const { return columns_ * rows_; }

  // The pixels of a tile that lie in the window.
  PixelRect tile(int index) const {
    const int x = (left_ + index % columns_) * size_, y = (top_ + index / columns_) * size_;
    return intersection({x, y, x + size_, y + size_}, window_);
  }

  // Whether a shard of the picture has this tile.
  bool has(const Shard& shard, int index) const { return shard.has(left_ + index % columns_, top_ + index / columns_); }

 private:
  PixelRect window_;
  int size_, left_, top_, columns_, rows_;
};

inline TileGrid tiles_of(const PixelRect& window, SampleCounts counts) {
  return TileGrid(window, counts == SampleCounts::uniform ? tile_size : noise_tile_size);
}

// The number of pixels of the grid's window that a shard has.
inline std::uint64_t pixel_count(const TileGrid& grid, const Shard& shard) {
  std::uint64_t pixels = 0;
  for (int i = 0; i < grid.count(); i++) {
    if (grid.has(shard, i)) pixels += grid.tile(i).pixel_count();
  }
  return pixels;
}

}  // namespace penumbra
