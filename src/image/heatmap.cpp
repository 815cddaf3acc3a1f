#include "image/comparison.hpp"

#include <algorithm>
#include <array>

namespace penumbra {
namespace {

// The ramp's colour for t, which is clamped to 0..1.
void heat_colour(float t, float rgb[3]) {
  constexpr std::array<std::array<float, 3>, 6> ramp{{{0.00f, 0.00f, 0.00f},
                                                      {0.22f, 0.08f, 0.45f},
                                                      {0.58f, 0.15f, 0.45f},
                                                      {0.89f, 0.32f, 0.22f},
                                                      {0.98f, 0.65f, 0.16f},
                                                      {1.00f, 0.98f, 0.76f}}};
  constexpr std::size_t steps = ramp.size() - 1;
  const float place = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(steps);
  const std::size_t below = std::min(static_cast<std::size_t>(place), steps - 1);
  const float part = place - static_cast<float>(below);
  for (std::size_t c = 0; c < 3; c++) rgb[c] = ramp[below][c] + part * (ramp[below + 1][c] - ramp[below][c]);
}

}  // namespace

Image heatmap(const std::vector<float>& differences, int width, int height, float scale) {
  Image image = make_image(width, height);
  for (std::size_t i = 0; i < differences.size(); i++) {
    const float d = differences[i];
    heat_colour(d > 0 && d >= scale ? 1.0f : d > 0 ? d / scale : 0.0f, &image.rgb[3 * i]);
  }
  return image;
}

}  // namespace penumbra
