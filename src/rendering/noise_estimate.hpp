// The standard error of a pixel's mean, estimated from its own samples. Stratified samples are not independent: the
// error of their mean is much smaller than their spread suggests. It shows in the differences between the means of
// parts of them. The samples are a sequence whose aligned blocks of 2^k are point sets of one kind, and the variance of
// a block's mean falls by one factor, the rate r, whenever the block doubles: r = 2 for independent samples, up to 8
// for nets and smooth functions (Owen 1997). If a mean has variance V, the means of its two halves then differ by
// 4 (r - 1) V in the mean square, and those of the quarters of one half by r times as much.
//
// One pixel has only three such differences, so its neighbours contribute to the rate and to the variance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/archive.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {

// Sums of r, g, b over a block of samples.
using ColorSum = std::array<double, 3>;

ColorSum operator+(const ColorSum& a, const ColorSum& b);
ColorSum operator-(const ColorSum& a, const ColorSum& b);

// The square of the difference of two colours.
struct SquaredDifference {
  float clamped = 0;           // as a screen shows them: each clamped to 0..1; the mean over r, g, b
  std::array<float, 3> rgb{};  // unclamped

  SquaredDifference& operator+=(const SquaredDifference& other);
};
SquaredDifference operator*(const SquaredDifference& d, float factor);

// Of the means of two blocks of `samples` samples each, given their sums.
SquaredDifference squared_difference(const ColorSum& a, const ColorSum& b, double samples);

// What is kept about a pixel's samples.
struct PixelNoise {
  SquaredDifference halves;       // between the first and the second half
  SquaredDifference quarters;     // between the quarters of a half: the mean over the halves known
  std::uint8_t halves_known = 0;  // whose quarters are known; 0: there is no such pixel
  std::uint8_t level = 0;         // log2 of the number of samples

  std::uint32_t samples() const { return 1u << level; }
};

template <class Archive>
void serialize(Archive& archive, Archived<Archive, PixelNoise>& noise) {
  for (auto* difference : {&noise.halves, &noise.quarters}) {
    archive(difference->clamped);
    for (auto& channel : difference->rgb) archive(channel);
  }
  archive(noise.halves_known);
  archive(noise.level);
  if constexpr (Archive::reads) {
    if (noise.level > 24 || noise.halves_known > 2) throw ArchiveError("the noise of a pixel is out of range");
  }
}

// The noise from four blocks of 2^level / 4 samples each.
PixelNoise first_noise(const std::array<ColorSum, 4>& blocks, int level);

// The noise after the number of samples has doubled; `before` and `added` are the sums of the old and the new samples.
// If the new ones came in two parts, `added_quarters` is the squared difference of the parts' means, else null.
PixelNoise doubled_noise(const PixelNoise& old, const ColorSum& before, const ColorSum& added,
                         const SquaredDifference* added_quarters);

// The pixels of a tile and those around it.
inline constexpr int noise_reach = 2;  // how far away a pixel still contributes
inline constexpr int noise_window_size = noise_tile_size + 2 * noise_reach;
using NoiseWindow = std::array<PixelNoise, noise_window_size * noise_window_size>;

// The possible rates.
struct NoiseRates {
  float lowest, expected, highest;
};
inline constexpr NoiseRates rates_of_independent_samples{2, 2, 2};
inline constexpr NoiseRates rates_of_nets{2, 2.3f, 3.2f};

// A number for each pixel of a window.
using WindowNumbers = std::array<float, noise_window_size * noise_window_size>;

// The rate observed in each pixel of the tile and those around it; meaningless for pixels outside the tile.
WindowNumbers observed_rates(const NoiseWindow& window, const NoiseRates& rates);

// Estimates at this rate for the pixel of the tile with this index in the window.
float squared_error(const NoiseWindow& window, std::size_t index, float rate);  // clamped; the mean over r, g, b
std::array<float, 3> variance(const NoiseWindow& window, std::size_t index, float rate);  // of the unclamped colours

}  // namespace penumbra
