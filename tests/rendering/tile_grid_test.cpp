// The tiles of a window, divided into shards or not, have each of its pixels once.
#include "rendering/tile_grid.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace penumbra {
namespace {

TEST(TileGrid, HasEveryPixelOfTheWindowOnce) {
  for (const PixelRect& window : {PixelRect{0, 0, 100, 70}, PixelRect{5, 9, 6, 10}, PixelRect{7, 3, 95, 66},
                                  PixelRect{0, 0, 16, 16}, PixelRect{0, 0, 33, 49}}) {
    for (const SampleCounts counts : {SampleCounts::uniform, SampleCounts::per_pixel}) {
      for (const int shards : {1, 3}) {
        std::vector<int> times(100 * 70);
        std::uint64_t pixels = 0;
        const TileGrid grid = tiles_of(window, counts);
        for (int shard = 0; shard < shards; shard++) {
          pixels += pixel_count(grid, {shard, shards});
          for (int i = 0; i < grid.count(); i++) {
            if (!grid.has({shard, shards}, i)) continue;
            const PixelRect tile = grid.tile(i);
            for (int y = tile.y0; y < tile.y1; y++) {
              for (int x = tile.x0; x < tile.x1; x++) times[static_cast<std::size_t>(100 * y + x)]++;
            }
          }
        }
        EXPECT_EQ(pixels, static_cast<std::uint64_t>(window.width()) * static_cast<std::uint64_t>(window.height()));
        for (int y = 0; y < 70; y++) {
          for (int x = 0; x < 100; x++) {
            const bool inside = x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1;
            EXPECT_EQ(times[static_cast<std::size_t>(100 * y + x)], inside) << x << ", " << y;
          }
        }
      }
    }
  }
}

// A pixel is in the same tile of any window: what is rendered together does not depend on the crop.
TEST(TileGrid, StartsAtThePictureAndNotAtTheWindow) {
  const TileGrid grid({13, 7, 40, 30});
  EXPECT_EQ(grid.tile(0), (PixelRect{13, 7, 16, 8}));
  EXPECT_EQ(grid.tile(grid.columns() + 1), (PixelRect{16, 8, 24, 16}));
  EXPECT_EQ(grid.tile(grid.count() - 1), (PixelRect{32, 24, 40, 30}));
}

}  // namespace
}  // namespace penumbra
