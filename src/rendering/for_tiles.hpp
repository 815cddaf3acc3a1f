// The one loop of the program over the tiles of a picture: every render goes through it.
#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "rendering/plan.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

// Calls `work(tile, rays)` once for each tile 0 <= tile < count, on `threads` threads that take the next tile whenever
// they are free, until all are done or the render is stopped. Returns the rays that all calls have counted.
template <class Work>
RayCounts for_tiles(int count, int threads, const RenderState& state, const Work& work) {
  std::atomic<int> next_tile{0};
  std::mutex total_mutex;
  RayCounts total;
  const auto run = [&] {
    RayCounts rays;
    while (!state.is_stopped()) {
      const int tile = next_tile.fetch_add(1, std::memory_order_relaxed);
      if (tile >= count) break;
      work(tile, rays);
    }
    const std::lock_guard lock(total_mutex);
    total += rays;
  };
  {
    std::vector<std::jthread> helpers;
    const int helper_count = std::max(std::min(threads, count) - 1, 0);
    helpers.reserve(static_cast<std::size_t>(helper_count));
    for (int i = 0; i < helper_count; i++) helpers.emplace_back(run);
    run();
  }
  return total;
}

}  // namespace penumbra
