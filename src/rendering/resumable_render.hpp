// A picture, or one shard of it, that is rendered in as many sittings as it takes. What the film holds in the end does
// not depend on where it was stopped.
#pragma once

#include <cstdint>

#include "base/archive.hpp"
#include "rendering/film.hpp"
#include "rendering/render_state.hpp"
#include "rendering/tile_grid.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

class ResumableRender {
 public:
  virtual ~ResumableRender() = default;

  // Goes on until it is finished or stopped. Returns the rays sent.
  virtual RayCounts run(RenderState& state) = 0;
  virtual bool is_finished() const = 0;
  // Pixels that got the most rays there are and would have had more.
  virtual std::uint64_t unfinished_pixels() const = 0;
  // The picture as it stands; nothing can be asked after that.
  virtual Film take_film() = 0;

  // What there is of each tile, for a file and back. Reading throws ArchiveError where the bytes cannot be a tile's.
  virtual const TileGrid& grid() const = 0;
  virtual bool has_begun(int tile) const = 0;
  virtual void write(ArchiveWriter& archive, int tile) const = 0;
  virtual void read(ArchiveReader& archive, int tile) = 0;
};

}  // namespace penumbra
