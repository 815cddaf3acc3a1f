// The work that a thread does between two looks at the stop flag: some pixels of a tile and, at a time, a number of
// their samples. It takes some hundredths of a second, judging by a rough count of the rays that a sample sends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rendering/film.hpp"
#include "rendering/plan.hpp"
#include "rendering/saved_sums.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

struct ChunkSize {
  std::size_t pixels;
  std::uint32_t samples;  // of each pixel at a time
};

// The largest chunk for this number of pixels, rounded up to a power of two: all of them and many samples, else half of
// them, and so on down to single pixels. A chunk of several pixels takes at least `fewest_samples`.
ChunkSize chunk_size(const Frame& frame, std::size_t pixels, std::uint32_t fewest_samples);

struct Chunk {
  std::span<const Pixel> pixels;
  std::uint32_t samples;

  // Where the batch of samples that starts at `first` ends, at most at `end`. Batches are whole packets of the widest
  // machine, which must not be cut where Embree is used (tracing/packets.hpp).
  std::uint32_t end_after(std::uint32_t first, std::uint32_t end) const;
};

// The one way in which samples enter a film; each thread has its own renderer.
struct ChunkRenderer {
  Film& film;
  const Frame& frame;
  const Kernel& kernel;
  RayCounts& rays;
  RenderState& state;
  FilmView view = film.view();

  // Calls `work(chunk)` for the chunks of some pixels until a call returns false. Returns the last result.
  template <class Work>
  bool for_chunks(std::span<const Pixel> pixels, std::uint32_t fewest_samples, const Work& work) const {
    const ChunkSize size = chunk_size(frame, pixels.size(), fewest_samples);
    for (auto left = pixels; !left.empty();) {
      const auto next = left.first(std::min(size.pixels, left.size()));
      if (!work(Chunk{next, size.samples})) return false;
      left = left.subspan(next.size());
    }
    return true;
  }

  // Adds the samples of a range to the pixels of a chunk, and calls `added(first, end)` after each batch, which the
  // film's counts do not include yet. Returns false if stopped before the end; what was given up has left no trace.
  template <class Added>
  bool render(const Chunk& chunk, SampleRange range, const Added& added) const {
    for (std::uint32_t first = range.first; first < range.end;) {
      if (state.is_stopped()) return false;
      const std::uint32_t end = chunk.end_after(first, range.end);
      const RayCounts rays_before = rays;
      const SavedSums sums_before(view, chunk.pixels);
      kernel.render_pixels(frame, view, {chunk.pixels, first, end, &state.give_up}, rays);
      if (state.give_up.load(std::memory_order_relaxed)) {
        sums_before.put_back(view, chunk.pixels);
        rays = rays_before;
        return false;
      }
      state.rays.fetch_add(rays.total() - rays_before.total(), std::memory_order_relaxed);
      added(first, end);
      first = end;
    }
    return true;
  }
  bool render(const Chunk& chunk, SampleRange range) const {
    return render(chunk, range, [](std::uint32_t, std::uint32_t) {});
  }
};

}  // namespace penumbra
