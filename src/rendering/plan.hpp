// How to render a picture, as one value: which part of it, with which layers, on how many threads.
#pragma once

#include <cstdint>

#include "base/pixel_rect.hpp"
#include "rendering/shard.hpp"
#include "tracing/layers.hpp"

namespace penumbra {

// Whether all pixels get the same number of samples, or each its own. If each has its own, the renderer also sets the
// variance of a pixel's mean, if there is such a layer: the squares of the samples do not give it.
enum class SampleCounts : std::uint8_t { uniform, per_pixel };

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

}  // namespace penumbra
