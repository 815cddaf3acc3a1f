// The tiles of a picture: squares of 16 pixels that start at its top left, as far as they lie in a window of it. They
// are numbered row by row.
#pragma once

#include <algorithm>
#include <cstdint>

#include "rendering/plan.hpp"

namespace penumbra {

inline constexpr int tile_size = 16;

class TileGrid {
 public:
  explicit TileGrid(const Crop& window)
      : window_(window),
        left_(window.x0 / tile_size),
        top_(window.y0 / tile_size),
        columns_((window.x1 + tile_size - 1) / tile_size - left_),
        rows_((window.y1 + tile_size - 1) / tile_size - top_) {}

  const Crop& window() const { return window_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int count() const { return columns_ * rows_; }

  // The pixels of a tile that lie in the window.
  Crop tile(int index) const {
    const int x = (left_ + index % columns_) * tile_size, y = (top_ + index / columns_) * tile_size;
    return {std::max(x, window_.x0), std::max(y, window_.y0), std::min(x + tile_size, window_.x1),
            std::min(y + tile_size, window_.y1)};
  }

  // Whether a shard of the picture has this tile.
  bool has(const Shard& shard, int index) const { return shard.has(left_ + index % columns_, top_ + index / columns_); }

 private:
  Crop window_;
  int left_, top_, columns_, rows_;
};

// How many pixels of a window a shard has.
inline std::uint64_t pixel_count(const Crop& window, const Shard& shard) {
  const TileGrid grid(window);
  std::uint64_t pixels = 0;
  for (int i = 0; i < grid.count(); i++) {
    if (!grid.has(shard, i)) continue;
    const Crop tile = grid.tile(i);
    pixels += static_cast<std::uint64_t>(tile.width()) * static_cast<std::uint64_t>(tile.height());
  }
  return pixels;
}

}  // namespace penumbra
