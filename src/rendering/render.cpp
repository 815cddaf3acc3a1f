#include "rendering/render.hpp"

#include <algorithm>

#include "rendering/chunk.hpp"
#include "rendering/for_tiles.hpp"
#include "rendering/pixel_list.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {
namespace {

// Renders until done or stopped. The pixels of a chunk always have the same number of samples.
void render_tile(const ChunkRenderer& renderer, const PixelRect& tile, SampleRange range) {
  const PixelList pixels = pixels_of(tile);
  renderer.for_chunks(pixels.all(), 1, [&](const Chunk& chunk) {
    const std::uint32_t done = renderer.film.samples_at(chunk.pixels.front());
    return renderer.render(
        chunk, {std::max(range.first, done), range.end}, [&](std::uint32_t first, std::uint32_t end) {
          renderer.film.set_samples(chunk.pixels, end);
          renderer.state.pixel_samples_done.fetch_add(chunk.pixels.size() * (end - first), std::memory_order_relaxed);
        });
  });
}

}  // namespace

RayCounts render_samples(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan, SampleRange range,
                         RenderState& state) {
  const TileGrid grid(film.crop());
  return for_tiles(grid.count(), plan.threads, state, [&](int tile, RayCounts& rays) {
    if (!grid.has(plan.shard, tile)) return;
    render_tile({film, frame, kernel, rays, state}, grid.tile(tile), range);
  });
}

}  // namespace penumbra
