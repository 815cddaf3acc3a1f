// Loops whose turns are independent of each other, on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace penumbra {

// Calls `work(i)` once for each 0 <= i < count, on at most `threads` threads that take the next i whenever they are
// free. A single call starts no thread. `work` must not throw.
template <class Work>
void parallel_for(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  const std::size_t together = std::min(count, static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::jthread> helpers;
  helpers.reserve(together);
  while (helpers.size() + 1 < together) helpers.emplace_back(run);
  run();
}

}  // namespace penumbra
