// Two rounds over the tiles of the picture. In the first, every pixel gets the same few samples, in four blocks whose
// means tell the pixel's error. In the second, each tile doubles the samples of the pixels that are worth it until none
// is left; of pixels outside the tile it knows the first round only, so that tiles do not wait for each other and no
// order of them shows.
#include "rendering/adaptive.hpp"

#include <algorithm>
#include <mutex>
#include <thread>

#include "rendering/first_round.hpp"
#include "rendering/pixel_list.hpp"
#include "rendering/portion.hpp"
#include "rendering/saved_sums.hpp"

namespace penumbra {
namespace {

// The whole tiles that cover a crop.
Crop whole_tiles(const Crop& crop, const Frame& frame) {
  const auto down = [](int v) { return v / noise_tile_size * noise_tile_size; };
  const auto up = [](int v, int end) {
    return std::min((v + noise_tile_size - 1) / noise_tile_size * noise_tile_size, end);
  };
  return {down(crop.x0), down(crop.y0), up(crop.x1, frame.settings.width), up(crop.y1, frame.settings.height)};
}

// What the pixels of a crop see, in a picture of this size.
Crop with_neighbours(const Crop& crop, int width, int height) {
  return {std::max(crop.x0 - noise_reach, 0), std::max(crop.y0 - noise_reach, 0),
          std::min(crop.x1 + noise_reach, width), std::min(crop.y1 + noise_reach, height)};
}

template <class Visit>
void for_pixels(const Crop& crop, const Visit& visit) {
  for (int y = crop.y0; y < crop.y1; y++) {
    for (int x = crop.x0; x < crop.x1; x++) visit(x, y);
  }
}

bool is_stopped(const RenderState& state) { return state.stop.load(std::memory_order_relaxed); }

}  // namespace

struct AdaptiveRender::Thread {
  RayCounts rays;
  TileRefinement refinement;
};

AdaptiveRender::AdaptiveRender(const Frame& frame, const Kernel& kernel, const Plan& plan, const NoiseGoal& goal)
    : plan_(plan),
      wanted_(whole_tiles(plan.crop, frame)),
      grid_(with_neighbours(wanted_, frame.settings.width, frame.settings.height), noise_tile_size),
      film_(grid_.window(), plan.layers, SampleCounts::per_pixel),
      frame_(frame),
      kernel_(kernel),
      rules_(goal, frame),
      noise_(static_cast<std::size_t>(grid_.window().width()) * static_cast<std::size_t>(grid_.window().height())),
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
  RayCounts rays = for_tiles(state, [&](int tile, Thread& thread) { render_first(tile, thread, state); });
  if (is_stopped(state)) return rays;
  state.pixel_samples_expected = of_first_round + sum_of(wanted, second_round);
  rays += for_tiles(state, [&](int tile, Thread& thread) {
    if (is_wanted(tile)) refine(tile, thread, state);
  });
  return rays;
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

template <class Archive, class Self>
void AdaptiveRender::exchange(Archive& archive, Self& self, int index) {
  auto& tile = self.tiles_[static_cast<std::size_t>(index)];
  const Crop pixels = self.grid_.tile(index);
  auto stage = static_cast<std::uint8_t>(tile.stage);
  archive(stage);
  archive(tile.unfinished);
  for_pixels(pixels, [&](int x, int y) { exchange_noise(archive, self.noise_[self.pixel_at(x, y)]); });
  if constexpr (Archive::reads) {
    if (stage > static_cast<int>(Stage::finished)) throw ArchiveError("a tile is in no stage that there is");
    tile.stage = static_cast<Stage>(stage);
    self.film_.read(archive, pixels);
    if (tile.stage != Stage::refining) return;
    tile.refinement = std::make_unique<TileRefinement>();
    tile.refinement->read(archive, pixels);
  } else {
    self.film_.write(archive, pixels);
    if (tile.refinement) tile.refinement->write(archive);
  }
}

void AdaptiveRender::write(ArchiveWriter& archive, int tile) const { exchange(archive, *this, tile); }
void AdaptiveRender::read(ArchiveReader& archive, int tile) { exchange(archive, *this, tile); }

// Calls `work(tile, thread)` for all tiles, by all threads, until it is stopped. Returns the rays sent.
template <class Work>
RayCounts AdaptiveRender::for_tiles(RenderState& state, const Work& work) {
  std::atomic<int> next_tile{0};
  std::mutex mutex;
  RayCounts rays;
  const auto run = [&] {
    Thread thread;
    while (!is_stopped(state)) {
      const int index = next_tile.fetch_add(1, std::memory_order_relaxed);
      if (index >= grid_.count()) break;
      const std::uint64_t rays_before = thread.rays.total();
      work(index, thread);
      state.rays.fetch_add(thread.rays.total() - rays_before, std::memory_order_relaxed);
    }
    const std::lock_guard lock(mutex);
    rays += thread.rays;
  };
  {
    std::vector<std::jthread> helpers;
    const int helper_count = std::min(plan_.threads, grid_.count()) - 1;
    helpers.reserve(static_cast<std::size_t>(std::max(helper_count, 0)));
    for (int i = 0; i < helper_count; i++) helpers.emplace_back(run);
    run();
  }
  return rays;
}

// Whether the tile in this column and row of the whole picture is to be finished.
bool AdaptiveRender::is_wanted(int column, int row) const {
  const int x = column * noise_tile_size, y = row * noise_tile_size;
  return x >= wanted_.x0 && y >= wanted_.y0 && x < wanted_.x1 && y < wanted_.y1 && plan_.shard.has(column, row);
}

bool AdaptiveRender::is_wanted(int tile) const {
  const Crop pixels = grid_.tile(tile);
  return is_wanted(pixels.x0 / noise_tile_size, pixels.y0 / noise_tile_size);
}

std::size_t AdaptiveRender::pixel_at(int x, int y) const {
  const Crop& area = grid_.window();
  return static_cast<std::size_t>(y - area.y0) * static_cast<std::size_t>(area.width()) +
         static_cast<std::size_t>(x - area.x0);
}

// Calls `visit(pixels)` for what the first round needs of a tile.
template <class Visit>
void AdaptiveRender::for_needed(int tile, const Visit& visit) const {
  for_first_round(
      grid_.tile(tile), [this](int column, int row) { return is_wanted(column, row); }, visit);
}

void AdaptiveRender::render_first(int index, Thread& thread, RenderState& state) {
  Tile& tile = tiles_[static_cast<std::size_t>(index)];
  if (tile.stage != Stage::none) return;
  for_needed(index, [&](const Crop& pixels) {
    if (!is_stopped(state)) render_first(pixels, thread, state);
  });
  if (is_stopped(state)) {
    film_.clear(grid_.tile(index));
    return;
  }
  tile.stage = Stage::first;
  state.pixel_samples_done.fetch_add(samples_of_first_round(index), std::memory_order_relaxed);
}

// The first round of some pixels of a tile; incomplete if it was stopped.
void AdaptiveRender::render_first(const Crop& pixels, Thread& thread, const RenderState& state) {
  const FilmView view = film_.view();
  const PixelList list = pixels_of(pixels);
  std::array<ColorSum, 4 * PixelList::most_pixels> sums;
  const std::uint32_t samples = (1u << rules_.first_level) / 4;
  for (std::uint32_t block = 0; block < 4; block++) {
    const SampleRange range{block * samples, (block + 1) * samples};
    if (!render_portions(view, frame_, kernel_, list.all(), range, thread.rays, state)) return;
    for (std::size_t i = 0; i < list.all().size(); i++) sums[4 * i + block] = color_sum(view, list.all()[i]);
  }
  for (std::size_t i = 0; i < list.all().size(); i++) {
    const ColorSum* s = &sums[4 * i];
    noise_[view.index_of(list.all()[i])] =
        first_noise({s[0], s[1] - s[0], s[2] - s[1], s[3] - s[2]}, rules_.first_level);
  }
  film_.set_samples(list.all(), 1u << rules_.first_level);
}

// The second round of a tile.
void AdaptiveRender::refine(int index, Thread& thread, RenderState& state) {
  Tile& tile = tiles_[static_cast<std::size_t>(index)];
  if (tile.stage == Stage::finished) return;
  TileRefinement& refinement = thread.refinement;
  if (tile.refinement) {
    refinement = *tile.refinement;
  } else {
    const Crop pixels = grid_.tile(index);
    refinement.begin(pixels, with_neighbours(pixels, frame_.settings.width, frame_.settings.height),
                     [this](int x, int y) { return noise_[pixel_at(x, y)]; });
  }
  const TileRefinement::Place place{film_, frame_, kernel_, rules_};
  if (!refinement.go_on(place, thread.rays, state)) {
    tile.refinement = std::make_unique<TileRefinement>(refinement);
    tile.stage = Stage::refining;
    return;
  }
  tile.unfinished = static_cast<std::uint16_t>(refinement.finish(place, plan_.crop));
  tile.refinement.reset();
  tile.stage = Stage::finished;
  state.pixel_samples_done.fetch_add(expected_samples(index), std::memory_order_relaxed);
}

// The sum of `samples(tile)` over all tiles that have `property(tile)`. For the progress only.
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
  for_needed(tile, [&pixels](const Crop& needed) {
    pixels += static_cast<std::uint64_t>(needed.width()) * static_cast<std::uint64_t>(needed.height());
  });
  return pixels << rules_.first_level;
}

// How many samples the second round of a tile may take.
std::uint64_t AdaptiveRender::expected_samples(int tile) const {
  std::uint64_t samples = 0;
  for_pixels(grid_.tile(tile), [&](int x, int y) {
    const int level = rules_.expected_level(noise_[pixel_at(x, y)]);
    samples += (std::uint64_t{1} << level) - (std::uint64_t{1} << rules_.first_level);
  });
  return samples;
}

AdaptiveResult render_adaptive(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan,
                               const NoiseGoal& goal, RenderState& state) {
  AdaptiveRender render(frame, kernel, {film.crop(), film.layers(), plan.threads, plan.shard}, goal);
  const RayCounts rays = render.run(state);
  film = render.take_film();
  return {rays, render.unfinished_pixels()};
}

}  // namespace penumbra
