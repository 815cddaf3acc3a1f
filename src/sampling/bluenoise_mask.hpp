// A mask of 128 x 128 pixels, each with one of the 64 x 64 cells of the unit square; every cell occurs four times.
// Pixels near each other have cells far from each other: in the square, along each axis, and on the disk to which the
// square is warped. So do the sets of 2, 4 and 8 points that bluenoise.hpp derives from each cell. The mask wraps
// around. Made by scripts/make_bluenoise_mask.cpp, which swaps pixels to lower the energy of Gaussian-weighted
// neighbours, a measure of low frequencies (as Ulichney 1993 and Heitz and Belcour 2019 for other masks).
#pragma once

#include <array>
#include <cstdint>

namespace penumbra {

inline constexpr std::uint32_t bluenoise_mask_size = 128;
inline constexpr int bluenoise_mask_bits = 6;  // of each of the two coordinates

// Row by row; the upper half of a word holds the first coordinate in its highest bits, the lower half the second.
extern const std::array<std::uint32_t, bluenoise_mask_size * bluenoise_mask_size> bluenoise_mask;

}  // namespace penumbra
