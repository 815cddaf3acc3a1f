// Two rounds over the tiles of the picture. In the first, every pixel gets the same few samples, in four blocks whose
// means give an estimate of the pixel's error. In the second, each tile keeps doubling the samples of the pixels that
// are worth it until none is left. Of pixels outside the tile it uses only the first round, so that tiles do not wait
// for each other and their order does not show.
#include "rendering/adaptive.hpp"

#include <algorithm>

#include "rendering/chunk.hpp"
#include "rendering/for_tiles.hpp"
#include "rendering/pixel_list.hpp"
#include "rendering/saved_sums.hpp"

namespace penumbra {
namespace {

// The whole tiles that cover a crop.
PixelRect whole_tiles(const PixelRect& crop, const Frame& frame) {
  const auto down = [](int v) { return v / noise_tile_size * noise_tile_size; };
  const auto up = [](int v, int end) {
    return std::min((v + noise_tile_size - 1) / noise_tile_size * noise_tile_size, end);
  };
  return {down(crop.x0), down(crop.y0), up(crop.x1, frame.settings.width), up(crop.y1, frame.settings.height)};
}

// A crop with the neighbours that its pixels' estimates use, inside the picture.
PixelRect with_neighbours(const PixelRect& crop, const Frame& frame) {
  return intersection({crop.x0 - noise_reach, crop.y0 - noise_reach, crop.x1 + noise_reach, crop.y1 + noise_reach},
                      {0, 0, frame.settings.width, frame.settings.height});
}

// The pixels of a tile that the first round needs: all if the tile is wanted, else those that the estimates of a wanted
// tile use. Calls `visit(pixels)` for parts of a tile that do not overlap. `is_wanted(column, row)` says whether the
// tile there, counted from the picture's top left, is wanted; no tile outside the picture is.
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

}  // namespace

AdaptiveRender::AdaptiveRender(const Frame& frame, const Kernel& kernel, const Plan& plan, const NoiseGoal& goal)
    : plan_(plan),
      wanted_(whole_tiles(plan.crop, frame)),
      grid_(with_neighbours(wanted_, frame), noise_tile_size),
      film_(grid_.window(), plan.layers, SampleCounts::per_pixel),
      frame_(frame),
      kernel_(kernel),
      rules_(goal, frame),
      noise_(grid_.window().pixel_count()),
      tiles_(static_cast<std::size_t>(grid_.count())) {}

RayCounts AdaptiveRender::run(RenderState& state) {
  const auto all = [](int) { return true; };
  const auto wanted = [this](int tile) { return is_wanted(tile); };
  const auto begun = [this](int tile) { return has_begun(tile); };
  const auto finished = [this](int tile) { return stage_of(tile) == Stage::finished; };
  const auto first_round = [this](int tile) { return samples_of_first_round(tile); };
  const auto second_round = [this](int tile) { return expected_samples(tile); };
  const std::uint64_t of_first_round = sum_of(all, first_round);
  const std::uint64_t done = sum_of(begun, first_round) + sum_of(finished, second_round);
  if (state.pixel_samples_done == 0) state.pixel_samples_before = done;
  state.pixel_samples_done = done;
  state.pixel_samples_expected = 2 * of_first_round;
  RayCounts sent = for_tiles(grid_.count(), plan_.threads, state, [&](int tile, RayCounts& rays) {
    render_first(tile, {film_, frame_, kernel_, rays, state});
  });
  if (state.is_stopped()) return sent;
  state.pixel_samples_expected = of_first_round + sum_of(wanted, second_round);
  sent += for_tiles(grid_.count(), plan_.threads, state, [&](int tile, RayCounts& rays) {
    if (is_wanted(tile)) refine(tile, {film_, frame_, kernel_, rays, state});
  });
  return sent;
}

bool AdaptiveRender::is_finished() const {
  for (int i = 0; i < grid_.count(); i++) {
    if (is_wanted(i) && stage_of(i) != Stage::finished) return false;
  }
  return true;
}

std::uint64_t AdaptiveRender::unfinished_pixels() const {
  std::uint64_t pixels = 0;
  for (const Tile& tile : tiles_) pixels += tile.unfinished;
  return pixels;
}

Film AdaptiveRender::take_film() { return plan_.crop == film_.crop() ? std::move(film_) : film_.cut(plan_.crop); }

template <class Archive>
void AdaptiveRender::serialize_tile(Archive& archive, Archived<Archive, AdaptiveRender>& render, int index) {
  auto& tile = render.tiles_[static_cast<std::size_t>(index)];
  const PixelRect pixels = render.grid_.tile(index);
  serialize_enum(archive, tile.stage, Stage::finished);
  archive(tile.unfinished);
  for_pixels(pixels, [&](int x, int y) { serialize(archive, render.noise_[render.film_.crop().index_of(x, y)]); });
  if constexpr (Archive::reads) {
    render.film_.read(archive, pixels);
    if (tile.stage != Stage::refining) return;
    tile.refinement = std::make_unique<TileRefinement>();
    tile.refinement->read(archive, pixels);
  } else {
    render.film_.write(archive, pixels);
    if (tile.refinement) tile.refinement->write(archive);
  }
}

void AdaptiveRender::write(ArchiveWriter& archive, int tile) const { serialize_tile(archive, *this, tile); }
void AdaptiveRender::read(ArchiveReader& archive, int tile) { serialize_tile(archive, *this, tile); }

// Whether the tile in this column and row of the whole picture has to be finished.
bool AdaptiveRender::is_wanted(int column, int row) const {
  return wanted_.contains(column * noise_tile_size, row * noise_tile_size) && plan_.shard.has(column, row);
}

bool AdaptiveRender::is_wanted(int tile) const {
  const PixelRect pixels = grid_.tile(tile);
  return is_wanted(pixels.x0 / noise_tile_size, pixels.y0 / noise_tile_size);
}

// Calls `visit(pixels)` for the pixels of a tile that the first round needs.
template <class Visit>
void AdaptiveRender::for_needed(int tile, const Visit& visit) const {
  for_first_round(
      grid_.tile(tile), [this](int column, int row) { return is_wanted(column, row); }, visit);
}

void AdaptiveRender::render_first(int index, const ChunkRenderer& renderer) {
  Tile& tile = tiles_[static_cast<std::size_t>(index)];
  if (tile.stage != Stage::none) return;
  for_needed(index, [&](const PixelRect& pixels) {
    if (!renderer.state.is_stopped()) render_first(pixels, renderer);
  });
  if (renderer.state.is_stopped()) {
    film_.clear(grid_.tile(index));
    return;
  }
  tile.stage = Stage::first;
  renderer.state.pixel_samples_done.fetch_add(samples_of_first_round(index), std::memory_order_relaxed);
}

// The first round of some pixels of a tile; incomplete if stopped.
void AdaptiveRender::render_first(const PixelRect& pixels, const ChunkRenderer& renderer) {
  const PixelList list = pixels_of(pixels);
  const std::uint32_t samples = (1u << rules_.first_level) / 4;
  renderer.for_chunks(list.all(), 1, [&](const Chunk& chunk) {
    std::array<std::array<ColorSum, 4>, PixelList::capacity> blocks;
    for (std::uint32_t block = 0; block < 4; block++) {
      if (!renderer.render(chunk, {block * samples, (block + 1) * samples})) return false;
      for (std::size_t i = 0; i < chunk.pixels.size(); i++) {
        blocks[i][block] = color_sum(renderer.view, chunk.pixels[i]);
      }
    }
    for (std::size_t i = 0; i < chunk.pixels.size(); i++) {
      const auto& [a, b, c, d] = blocks[i];
      noise_[film_.crop().index_of(chunk.pixels[i])] = first_noise({a, b - a, c - b, d - c}, rules_.first_level);
    }
    film_.set_samples(chunk.pixels, 1u << rules_.first_level);
    return true;
  });
}

// The second round of a tile.
void AdaptiveRender::refine(int index, const ChunkRenderer& renderer) {
  Tile& tile = tiles_[static_cast<std::size_t>(index)];
  if (tile.stage == Stage::finished) return;
  TileRefinement refinement;
  if (tile.refinement) {
    refinement = *tile.refinement;
  } else {
    const PixelRect pixels = grid_.tile(index);
    refinement.begin(pixels, with_neighbours(pixels, frame_),
                     [this](int x, int y) { return noise_[film_.crop().index_of(x, y)]; });
  }
  if (!refinement.go_on(renderer, rules_)) {
    tile.refinement = std::make_unique<TileRefinement>(refinement);
    tile.stage = Stage::refining;
    return;
  }
  tile.unfinished = static_cast<std::uint16_t>(refinement.finish(film_, rules_, plan_.crop));
  tile.refinement.reset();
  tile.stage = Stage::finished;
  renderer.state.pixel_samples_done.fetch_add(expected_samples(index), std::memory_order_relaxed);
}

// The sum of `samples(tile)` over all tiles with `property(tile)`, for progress only.
template <class Property, class Samples>
std::uint64_t AdaptiveRender::sum_of(const Property& property, const Samples& samples) const {
  std::uint64_t sum = 0;
  for (int i = 0; i < grid_.count(); i++) {
    if (property(i)) sum += samples(i);
  }
  return sum;
}

std::uint64_t AdaptiveRender::samples_of_first_round(int tile) const {
  std::uint64_t pixels = 0;
  for_needed(tile, [&pixels](const PixelRect& needed) { pixels += needed.pixel_count(); });
  return pixels << rules_.first_level;
}

// An estimate of the samples that the second round of a tile takes.
std::uint64_t AdaptiveRender::expected_samples(int tile) const {
  std::uint64_t samples = 0;
  for_pixels(grid_.tile(tile), [&](int x, int y) {
    const int level = rules_.expected_level(noise_[film_.crop().index_of(x, y)]);
    samples += (std::uint64_t{1} << level) - (std::uint64_t{1} << rules_.first_level);
  });
  return samples;
}

}  // namespace penumbra
