// How much a thread renders in one go before it looks up whether it shall stop: some hundredths of a second of work,
// by a rough guess from the number of rays that a sample sends.
#pragma once

#include <cstdint>

#include "rendering/plan.hpp"
#include "rendering/render.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

struct Portion {
  int width = 0, height = 0;  // pixels of a tile
  std::uint32_t samples = 0;  // of each of them

  // Where the samples that follow `first` end, if they shall go up to `end`. Samples come in whole packets of the
  // widest machine: these may not be cut where Embree is asked (tracing/tile.hpp).
  std::uint32_t end_after(std::uint32_t first, std::uint32_t end) const;
};

// The largest portion of `width` x `height` pixels: the whole of them and many samples, else rows of them, else pixel
// by pixel.
Portion portion_for(const Frame& frame, int width, int height);

// Adds the samples of a range to some pixels of a film, portion by portion; false if it was stopped before the end.
bool render_portions(const FilmView& film, const Frame& frame, const Kernel& kernel, const Crop& pixels,
                     SampleRange range, RayCounts& counts, const RenderState& state);

}  // namespace penumbra
