// How to render a picture, as one value: which part of it, with which layers, on how many threads.
#pragma once

#include <atomic>
#include <cstdint>

#include "base/pixel_rect.hpp"
#include "tracing/layers.hpp"

namespace penumbra {

// Whether all pixels get the same number of samples, or each its own. If each has its own, the renderer also sets the
// variance of a pixel's mean, if there is such a layer: the squares of the samples do not give it.
enum class SampleCounts : std::uint8_t { uniform, per_pixel };

inline constexpr int most_shards = 1'000'000;

// A part of a picture that is divided among several runs of the program: each renders its own tiles, spread all over
// the picture so that the work is even. Shard `index` of `count`, counted from 0.
struct Shard {
  int index = 0, count = 1;

  // Whether it has the tile in this column and row of the picture. In a row, it has every `count`-th tile; from row to
  // row, its first tile moves by the golden section of `count`. So its tiles form a lattice without a preferred
  // direction, with equally many tiles in every part of the picture.
  bool has(int column, int row) const {
    if (count == 1) return true;
    const std::uint64_t section = std::uint64_t{static_cast<std::uint32_t>(row) * 0x9e3779b9u};  // in units of 2^-32
    const std::uint64_t shift = section * static_cast<std::uint64_t>(count) >> 32;
    const std::uint64_t owner = (static_cast<std::uint64_t>(column) + shift) % static_cast<std::uint64_t>(count);
    return owner == static_cast<std::uint64_t>(index);
  }

  bool operator==(const Shard&) const = default;
};

struct Plan {
  PixelRect crop;
  Layers layers;
  int threads = 1;
  Shard shard = {};  // only its tiles are rendered
};

// Samples first <= index < end of every pixel.
struct SampleRange {
  std::uint32_t first = 0, end = 0;
};

// What a render shares with the code that watches or stops it.
struct RenderState {
  std::atomic<std::uint64_t> pixel_samples_done{0};      // pixels times samples
  std::atomic<std::uint64_t> pixel_samples_before{0};    // of these, in earlier sessions
  std::atomic<std::uint64_t> pixel_samples_expected{0};  // in total; 0: the render has no better estimate
  std::atomic<std::uint64_t> rays{0};
  // Either ends the render, and calling it again resumes it. `stop` ends it when the samples in work are complete,
  // usually in some hundredths of a second; `give_up` drops them, at once whatever the scene.
  std::atomic<bool> stop{false}, give_up{false};

  bool is_stopped() const { return stop.load(std::memory_order_relaxed) || give_up.load(std::memory_order_relaxed); }
};

}  // namespace penumbra
