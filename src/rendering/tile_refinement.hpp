// The second round of one tile of an adaptive render: the samples of all pixels that are worth it are doubled, again
// and again, until none is. It can be stopped between any two chunks of them, and goes on in the same way.
#pragma once

#include <array>
#include <cstdint>

#include "base/archive.hpp"
#include "rendering/adaptive_rules.hpp"
#include "rendering/chunk.hpp"
#include "rendering/film.hpp"

namespace penumbra {

class TileRefinement {
 public:
  // Starts with the noise after the first round: `noise_at(x, y)` for the pixels of `seen`, which are those of the tile
  // and as many around it as there are, at most `noise_reach`.
  template <class NoiseAt>
  void begin(const PixelRect& tile, const PixelRect& seen, const NoiseAt& noise_at) {
    tile_ = tile;
    window_.fill({});
    marks_.fill(Mark::none);
    for_pixels(seen, [&](int x, int y) { window_[window_pixels().index_of(x, y)] = noise_at(x, y); });
  }

  // False if it was stopped before the end.
  bool go_on(const ChunkRenderer& renderer, const AdaptiveRules& rules);

  // At the end: what the film does not know yet, and how many pixels of `crop` would have had more samples.
  int finish(Film& film, const AdaptiveRules& rules, const PixelRect& crop) const;

  // All of it but the tile.
  void write(ArchiveWriter& archive) const;
  void read(ArchiveReader& archive, const PixelRect& tile);

 private:
  // `due`: in this turn, the pixel's samples are to be doubled yet. `at_end`: it has the most samples there are.
  enum class Mark : std::uint8_t { none, due, at_end };

  // The pixels of the window, in the picture.
  PixelRect window_pixels() const {
    const int x = tile_.x0 - noise_reach, y = tile_.y0 - noise_reach;
    return {x, y, x + noise_window_size, y + noise_window_size};
  }
  bool double_due(const ChunkRenderer& renderer);
  bool double_samples(const Chunk& chunk, int level, const ChunkRenderer& renderer);
  bool mark_due(const AdaptiveRules& rules);
  template <class Archive>
  static void serialize_window(Archive& archive, Archived<Archive, TileRefinement>& refinement);

  PixelRect tile_;
  NoiseWindow window_;
  std::array<Mark, noise_window_size * noise_window_size> marks_;
};

}  // namespace penumbra
