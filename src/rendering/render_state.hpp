// What a render shares with the code that watches or stops it.
#pragma once

#include <atomic>
#include <cstdint>

namespace penumbra {

struct RenderState {
  std::atomic<std::uint64_t> pixel_samples_done{0};      // pixels times samples
  std::atomic<std::uint64_t> pixel_samples_before{0};    // of these, in earlier sessions
  std::atomic<std::uint64_t> pixel_samples_expected{0};  // in total; 0: the render has no better estimate
  std::atomic<std::uint64_t> rays{0};
  std::atomic<bool> stop{false};  // ends the render in some hundredths of a second; calling it again resumes it

  bool is_stopped() const { return stop.load(std::memory_order_relaxed); }
};

}  // namespace penumbra
