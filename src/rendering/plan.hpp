// How a picture is to be rendered, as one value: which part of it, with which extra layers, by how many threads.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "rendering/shard.hpp"

namespace penumbra {

// Pixels x0 <= x < x1, y0 <= y < y1, counted from the top left of the full picture.
struct Crop {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool operator==(const Crop&) const = default;
};

// The layers beside the colour that can be asked for.
struct Layers {
  bool depth = false, normal = false, albedo = false, variance = false, samples = false;

  bool any() const { return depth || normal || albedo || variance || samples; }
  bool operator==(const Layers&) const = default;
};

inline constexpr std::string_view layer_names[] = {"depth", "normal", "albedo", "variance", "samples"};
bool add_layer(Layers& layers, std::string_view name);
std::string to_string(const Layers& layers);

// Whether all pixels are to have the same number of samples, or each its own. Where each has its own, whoever renders
// also says the variance of a pixel's mean, if there is such a layer: the squares of the samples do not tell it.
enum class SampleCounts { uniform, per_pixel };

struct Plan {
  Crop crop;
  Layers layers;
  int threads = 1;
  Shard shard = {};  // only its tiles are rendered
};

// Samples first <= index < end of every pixel.
struct SampleRange {
  std::uint32_t first = 0, end = 0;
};

}  // namespace penumbra
