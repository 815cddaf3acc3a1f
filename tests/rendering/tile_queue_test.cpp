// Tiles and quarters of tiles as they are handed out: every pixel once, small ones last.
#include "rendering/tile_queue.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace penumbra {
namespace {

std::vector<Crop> all_of(const TileGrid& grid, const Shard& shard, int threads) {
  std::vector<Crop> pieces;
  TileQueue queue(grid, shard, threads);
  while (const auto piece = queue.next()) pieces.push_back(*piece);
  return pieces;
}

TEST(TileQueue, HandsOutEveryPixelOnce) {
  for (const Crop& window : {Crop{0, 0, 100, 70}, Crop{5, 9, 6, 10}, Crop{7, 3, 95, 66}, Crop{0, 0, 16, 16}}) {
    for (const int threads : {1, 2, 5, 300}) {
      for (const int shards : {1, 3}) {
        std::vector<int> times(100 * 70);
        const TileGrid grid(window);
        for (int shard = 0; shard < shards; shard++) {
          for (const Crop& piece : all_of(grid, {shard, shards}, threads)) {
            for (int y = piece.y0; y < piece.y1; y++) {
              for (int x = piece.x0; x < piece.x1; x++) times[static_cast<std::size_t>(100 * y + x)]++;
            }
          }
        }
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

TEST(TileQueue, TheLastTilesComeInQuarters) {
  const TileGrid grid({0, 0, 160, 160});
  const std::vector<Crop> pieces = all_of(grid, {}, 3);
  ASSERT_EQ(pieces.size(), 94u + 6 * 4);
  EXPECT_EQ(pieces[93], (Crop{48, 144, 64, 160}));
  EXPECT_EQ(pieces[94], (Crop{64, 144, 72, 152}));
  EXPECT_EQ(pieces.back(), (Crop{152, 152, 160, 160}));
}

TEST(TileQueue, OneThreadGetsWholeTiles) { EXPECT_EQ(all_of(TileGrid({0, 0, 160, 160}), {}, 1).size(), 100u); }

}  // namespace
}  // namespace penumbra
