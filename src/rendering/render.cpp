#include "rendering/render.hpp"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "rendering/pixel_list.hpp"
#include "rendering/portion.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {
namespace {

struct FreeCpuSet {
  void operator()(cpu_set_t* set) const { CPU_FREE(set); }
};

// Adds the samples to a tile, portion by portion, until it is done or told to stop. The pixels of a portion have the
// same number of samples.
void render_tile(Film& film, const FilmView& view, const Frame& frame, const Kernel& kernel, const Crop& tile,
                 SampleRange range, RayCounts& counts, RenderState& state) {
  const Portion portion = portion_for(frame, std::size_t{tile_size} * tile_size);
  const PixelList pixels = pixels_of(tile);
  for (auto left = pixels.all(); !left.empty();) {
    const auto next = portion.next_of(left);
    const std::uint32_t done = film.samples_at(static_cast<int>(next[0].x), static_cast<int>(next[0].y));
    for (std::uint32_t first = std::max(range.first, done); first < range.end;) {
      if (state.stop.load(std::memory_order_relaxed)) return;
      const std::uint32_t end = portion.end_after(first, range.end);
      const std::uint64_t rays_before = counts.total();
      kernel.render_pixels(frame, view, {next, first, end}, counts);
      film.set_samples(next, end);
      state.pixel_samples_done.fetch_add(next.size() * (end - first), std::memory_order_relaxed);
      state.rays.fetch_add(counts.total() - rays_before, std::memory_order_relaxed);
      first = end;
    }
    left = left.subspan(next.size());
  }
}

}  // namespace

RayCounts render_samples(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan, SampleRange range,
                         RenderState& state) {
  const FilmView view = film.view();
  const TileGrid grid(film.crop());
  std::atomic<int> next_tile{0};
  std::mutex counts_mutex;
  RayCounts total;
  const auto work = [&] {
    RayCounts counts;
    while (!state.stop.load(std::memory_order_relaxed)) {
      const int tile = next_tile.fetch_add(1, std::memory_order_relaxed);
      if (tile >= grid.count()) break;
      if (grid.has(plan.shard, tile)) render_tile(film, view, frame, kernel, grid.tile(tile), range, counts, state);
    }
    const std::lock_guard lock(counts_mutex);
    total += counts;
  };
  {
    std::vector<std::jthread> helpers;
    const int helper_count = std::min(plan.threads, grid.count()) - 1;
    helpers.reserve(static_cast<std::size_t>(std::max(helper_count, 0)));
    for (int i = 0; i < helper_count; i++) helpers.emplace_back(work);
    work();
  }
  return total;
}

int default_thread_count() {
  if (const char* slurm = std::getenv("SLURM_CPUS_PER_TASK")) {
    int count = 0;
    const char* end = slurm + std::strlen(slurm);
    if (std::from_chars(slurm, end, count).ptr == end && count > 0) return count;
  }
  // A mask may have more places than cpu_set_t, on machines that have.
  for (int places = CPU_SETSIZE; places <= 1 << 20; places *= 2) {
    const std::unique_ptr<cpu_set_t, FreeCpuSet> allowed(CPU_ALLOC(places));
    const std::size_t size = CPU_ALLOC_SIZE(places);
    if (allowed && sched_getaffinity(0, size, allowed.get()) == 0) return std::max(CPU_COUNT_S(size, allowed.get()), 1);
  }
  return 1;
}

}  // namespace penumbra
