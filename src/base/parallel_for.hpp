// Loops whose turns are independent of each other, on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace penumbra {

// Calls `run()` on so many threads at once, this one among them, and waits for all of them. It must not throw.
template <class Run>
void run_on_threads(int threads, const Run& run) {
  std::vector<std::jthread> helpers;
  const int helper_count = std::max(threads - 1, 0);
  helpers.reserve(static_cast<std::size_t>(helper_count));
  for (int i = 0; i < helper_count; i++) helpers.emplace_back(run);
  run();
}

// Calls `work(i)` once for each 0 <= i < count, on at most `threads` threads that take the next i whenever they are
// free. A single call starts no thread. `work` must not throw.
template <class Work>
void parallel_for(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  run_on_threads(count < static_cast<std::size_t>(std::max(threads, 1)) ? static_cast<int>(count) : threads, run);
}

}  // namespace penumbra
