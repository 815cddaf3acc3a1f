#include "rendering/render.hpp"

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

namespace penumbra {
namespace {

constexpr int tile_size = 16;

TileSamples tile_at(const Crop& crop, int index, SampleRange range) {
  const int columns = (crop.width() + tile_size - 1) / tile_size;
  const int x0 = crop.x0 + index % columns * tile_size;
  const int y0 = crop.y0 + index / columns * tile_size;
  return {x0, y0, std::min(x0 + tile_size, crop.x1), std::min(y0 + tile_size, crop.y1), range.first, range.end};
}

int tile_count(const Crop& crop) {
  return ((crop.width() + tile_size - 1) / tile_size) * ((crop.height() + tile_size - 1) / tile_size);
}

}  // namespace

RayCounts render_samples(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan, SampleRange range,
                         RenderState& state) {
  const FilmView view = film.view();
  const int tiles = tile_count(film.crop());
  std::atomic<int> next_tile{0};
  std::mutex counts_mutex;
  RayCounts total;
  const auto work = [&] {
    RayCounts counts;
    while (!state.stop.load(std::memory_order_relaxed)) {
      const int index = next_tile.fetch_add(1, std::memory_order_relaxed);
      if (index >= tiles) break;
      const TileSamples tile = tile_at(film.crop(), index, range);
      const std::uint64_t rays_before = counts.total();
      kernel.render_tile(frame, view, tile, counts);
      const auto pixels = std::uint64_t(tile.x1 - tile.x0) * std::uint64_t(tile.y1 - tile.y0);
      state.pixel_samples_done.fetch_add(pixels * (range.end - range.first), std::memory_order_relaxed);
      state.rays.fetch_add(counts.total() - rays_before, std::memory_order_relaxed);
    }
    const std::lock_guard lock(counts_mutex);
    total += counts;
  };
  {
    std::vector<std::jthread> helpers;
    const int helper_count = std::min(plan.threads, tiles) - 1;
    helpers.reserve(static_cast<std::size_t>(std::max(helper_count, 0)));
    for (int i = 0; i < helper_count; i++) helpers.emplace_back(work);
    work();
  }
  if (!state.stop.load()) film.add_samples(range.end - range.first);
  return total;
}

int default_thread_count() {
  if (const char* slurm = std::getenv("SLURM_CPUS_PER_TASK")) {
    int count = 0;
    const char* end = slurm + std::strlen(slurm);
    if (std::from_chars(slurm, end, count).ptr == end && count > 0) return count;
  }
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return std::max(CPU_COUNT(&allowed), 1);
  return std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
}

}  // namespace penumbra
