// The second round of one tile of an adaptive render: the samples of all pixels that are worth it are doubled, again
// and again, until none is. It can be stopped between any two portions of them, and goes on in the same way.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/archive.hpp"
#include "rendering/adaptive_rules.hpp"
#include "rendering/film.hpp"
#include "rendering/render.hpp"

namespace penumbra {

class TileRefinement {
 public:
  // What renders the samples, and where they go.
  struct Place {
    Film& film;
    const Frame& frame;
    const Kernel& kernel;
    const AdaptiveRules& rules;
  };

  // Starts with the noise after the first round: `noise_at(x, y)` for the pixels of `seen`, which are those of the tile
  // and as many around it as there are, at most `noise_reach`.
  template <class NoiseAt>
  void begin(const Crop& tile, const Crop& seen, const NoiseAt& noise_at) {
    tile_ = tile;
    window_.fill({});
    marks_.fill(Mark::none);
    for (int y = seen.y0; y < seen.y1; y++) {
      for (int x = seen.x0; x < seen.x1; x++) window_[index_of(x, y)] = noise_at(x, y);
    }
  }

  // False if it was stopped before the end.
  bool go_on(const Place& place, RayCounts& counts, const RenderState& state);

  // At the end: what the film does not know yet, and how many pixels of `crop` would have had more samples.
  int finish(const Place& place, const Crop& crop) const;

  // All of it but the tile.
  void write(ArchiveWriter& archive) const;
  void read(ArchiveReader& archive, const Crop& tile);

 private:
  // `due`: in this turn, the pixel's samples are to be doubled yet. `at_end`: it has the most samples there are.
  enum class Mark : std::uint8_t { none, due, at_end };

  std::size_t index_of(PixelPlace pixel) const {
    return index_of(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  }
  std::size_t index_of(int x, int y) const {
    const int column = x - tile_.x0 + noise_reach, row = y - tile_.y0 + noise_reach;
    return static_cast<std::size_t>(row) * noise_window_size + static_cast<std::size_t>(column);
  }
  bool double_due(const Place& place, RayCounts& counts, const RenderState& state);
  bool double_samples(std::span<const PixelPlace> pixels, int level, const Place& place, RayCounts& counts,
                      const RenderState& state);
  bool mark_due(const AdaptiveRules& rules);
  template <class Archive, class Self>
  static void exchange(Archive& archive, Self& self);

  Crop tile_;
  NoiseWindow window_;
  std::array<Mark, noise_window_size * noise_window_size> marks_;
};

}  // namespace penumbra
