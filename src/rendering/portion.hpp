// How much a thread renders in one go before it looks up whether it shall stop: some hundredths of a second of work,
// by a rough guess from the number of rays that a sample sends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rendering/plan.hpp"
#include "rendering/render.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

struct Portion {
  std::size_t pixels = 0;     // of a tile
  std::uint32_t samples = 0;  // of each of them

  // Those of `left` that are next.
  std::span<const PixelPlace> next_of(std::span<const PixelPlace> left) const {
    return left.first(std::min(pixels, left.size()));
  }

  // Where the samples that follow `first` end, if they shall go up to `end`. Samples come in whole packets of the
  // widest machine: these may not be cut where Embree is asked (tracing/packets.hpp).
  std::uint32_t end_after(std::uint32_t first, std::uint32_t end) const;
};

// The largest portion of so many pixels, a power of two: all of them and many samples, else halves of them, and so on
// down to single pixels. Of several pixels it has `fewest_samples` or more.
Portion portion_for(const Frame& frame, std::size_t pixels, std::uint32_t fewest_samples = 1);

// Adds the samples of a range to some pixels of a film, portion by portion; false if it was stopped before the end.
bool render_portions(const FilmView& film, const Frame& frame, const Kernel& kernel, std::span<const PixelPlace> pixels,
                     SampleRange range, RayCounts& counts, const RenderState& state);

}  // namespace penumbra
