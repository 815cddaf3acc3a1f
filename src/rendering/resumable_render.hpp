// A picture, or one shard of it, that is rendered in as many sessions as it takes. The final film does not depend on
// where the render was stopped.
#pragma once

#include <cstdint>

#include "base/archive.hpp"
#include "rendering/film.hpp"
#include "rendering/plan.hpp"
#include "rendering/tile_grid.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

class ResumableRender {
 public:
  virtual ~ResumableRender() = default;

  // Renders until finished or stopped. Returns the rays sent.
  virtual RayCounts run(RenderState& state) = 0;
  virtual bool is_finished() const = 0;
  // The number of pixels that got the maximum of rays but needed more.
  virtual std::uint64_t unfinished_pixels() const = 0;
  // Whether the state of a render of so many rays per pixel, fewer than this one's, is also a state of this one.
  virtual bool can_go_on_from(std::uint32_t /*rays*/) const { return false; }
  // The picture as it stands. The render cannot be used after that.
  virtual Film take_film() = 0;

  // The state of each tile, to a file and back. Reading throws ArchiveError if the bytes are not a valid tile.
  virtual const TileGrid& grid() const = 0;
  virtual bool has_begun(int tile) const = 0;
  virtual void write(ArchiveWriter& archive, int tile) const = 0;
  virtual void read(ArchiveReader& archive, int tile) = 0;
};

}  // namespace penumbra
