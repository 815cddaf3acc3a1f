// The pixels that the first round of an adaptive render needs: those of the wanted tiles, and those of other tiles that
// the estimates of a wanted tile use.
#pragma once

#include "rendering/noise_estimate.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {

// Calls `visit(pixels)` for parts of a tile that do not overlap. `is_wanted(column, row)` says whether the tile there,
// counted from the picture's top left, is wanted; no tile outside the picture is.
template <class IsWanted, class Visit>
void for_first_round(const PixelRect& tile, const IsWanted& is_wanted, const Visit& visit) {
  const int column = tile.x0 / noise_tile_size, row = tile.y0 / noise_tile_size;
  if (is_wanted(column, row)) {
    visit(tile);
    return;
  }
  // The tile in three by three cells, of which a neighbour uses those on its side.
  const auto cut = [](int start, int cell) {
    return start * noise_tile_size + (cell == 0   ? 0
                                      : cell == 1 ? noise_reach
                                      : cell == 2 ? noise_tile_size - noise_reach
                                                  : noise_tile_size);
  };
  for (int cy = 0; cy < 3; cy++) {
    for (int cx = 0; cx < 3; cx++) {
      const int dx = cx - 1, dy = cy - 1;
      const bool seen = (dx != 0 && is_wanted(column + dx, row)) || (dy != 0 && is_wanted(column, row + dy)) ||
                        (dx != 0 && dy != 0 && is_wanted(column + dx, row + dy));
      const PixelRect cell = intersection({cut(column, cx), cut(row, cy), cut(column, cx + 1), cut(row, cy + 1)}, tile);
      if (seen && cell.x0 < cell.x1 && cell.y0 < cell.y1) visit(cell);
    }
  }
}

}  // namespace penumbra
