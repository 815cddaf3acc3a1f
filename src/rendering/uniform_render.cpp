#include "rendering/uniform_render.hpp"

#include <algorithm>

#include "rendering/chunk.hpp"
#include "rendering/for_tiles.hpp"
#include "rendering/pixel_list.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {
namespace {

constexpr std::uint32_t samples_of_first_pass = 16;

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

UniformRender::UniformRender(const Frame& frame, const Kernel& kernel, const Plan& plan, std::uint32_t rays,
                             bool in_passes)
    : frame_(frame),
      kernel_(kernel),
      plan_(plan),
      rays_(rays),
      in_passes_(in_passes),
      grid_(plan.crop),
      film_(plan.crop, plan.layers) {}

RayCounts UniformRender::run(RenderState& state) {
  if (state.pixel_samples_done == 0) state.pixel_samples_before = film_.total_samples();
  state.pixel_samples_done = film_.total_samples();
  RayCounts rays;
  std::uint32_t end = in_passes_ ? std::min(samples_of_first_pass, rays_) : rays_;
  for (;;) {
    rays += render_samples(film_, frame_, kernel_, plan_, {0, end}, state);
    if (end == rays_ || state.is_stopped()) return rays;
    end = end > rays_ / 2 ? rays_ : 2 * end;
  }
}

bool UniformRender::is_finished() const {
  bool finished = true;
  for (int i = 0; i < grid_.count(); i++) {
    if (!grid_.has(plan_.shard, i)) continue;
    for_pixels(grid_.tile(i), [&](int x, int y) { finished = finished && film_.samples_at(x, y) >= rays_; });
  }
  return finished;
}

// A single ray has a place of its own in the pixel.
bool UniformRender::can_go_on_from(std::uint32_t rays) const {
  return rays > 1 && !needs_count(frame_.settings.pattern) && !frame_.settings.regular_lights;
}

// No pixel of a tile is ahead of the first one.
bool UniformRender::has_begun(int tile) const {
  const PixelRect pixels = grid_.tile(tile);
  return film_.samples_at(pixels.x0, pixels.y0) > 0;
}

void UniformRender::read(ArchiveReader& archive, int tile) {
  const PixelRect pixels = grid_.tile(tile);
  film_.read(archive, pixels);
  for_pixels(pixels, [&](int x, int y) {
    if (film_.samples_at(x, y) > rays_) throw ArchiveError("a pixel has too many samples");
  });
}

}  // namespace penumbra
