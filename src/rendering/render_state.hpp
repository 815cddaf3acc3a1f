// What a render shares with whoever watches or stops it.
#pragma once

#include <atomic>
#include <cstdint>

namespace penumbra {

struct RenderState {
  std::atomic<std::uint64_t> pixel_samples_done{0};      // pixels times samples
  std::atomic<std::uint64_t> pixel_samples_before{0};    // of these, in earlier sittings
  std::atomic<std::uint64_t> pixel_samples_expected{0};  // in all; 0: whoever renders does not know better
  std::atomic<std::uint64_t> rays{0};
  std::atomic<bool> stop{false};  // ends the render in some hundredths of a second; calling it again goes on

  bool is_stopped() const { return stop.load(std::memory_order_relaxed); }
};

}  // namespace penumbra
