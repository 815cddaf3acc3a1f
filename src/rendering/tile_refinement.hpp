// The second round of one tile of an adaptive render: it doubles the samples of all pixels that are worth it, again and
// again, until none is. It can be stopped between any two chunks and resumed, which does not show in the result.
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
  // and of the picture up to `noise_reach` around it.
  template <class NoiseAt>
  void begin(const PixelRect& tile, const PixelRect& seen, const NoiseAt& noise_at) {
    tile_ = tile;
    window_.fill({});
    marks_.fill(Mark::none);
    for_pixels(seen, [&](int x, int y) { window_[window_pixels().index_of(x, y)] = noise_at(x, y); });
  }

  // Returns false if stopped before the end.
  bool go_on(const ChunkRenderer& renderer, const AdaptiveRules& rules);

  // At the end, sets the variance in the film. Returns how many pixels of `crop` needed more samples.
  int finish(Film& film, const AdaptiveRules& rules, const PixelRect& crop) const;

  // Everything but the tile itself.
  void write(ArchiveWriter& archive) const;
  void read(ArchiveReader& archive, const PixelRect& tile);

 private:
  // `due`: the pixel's samples still have to be doubled in this turn. `at_end`: it has the maximum but needs more.
  enum class Mark : std::uint8_t { none, due, at_end };

  // The pixels of the window, in coordinates of the picture.
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
