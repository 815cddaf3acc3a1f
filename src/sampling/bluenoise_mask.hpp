// A mask of 128 x 128 pixels, each with a place of the unit square in 64 x 64 cells; every cell is four times in it.
// Pixels near each other have places far from each other, in the square, along each side, and in the disk that the
// square is bent to; so have the sets of 2, 4 and 8 places around each that bluenoise.hpp makes. The ends meet.
// Made by scripts/make_bluenoise_mask.cpp: pixels are swapped while that lowers the energy of Gaussian-weighted
// neighbours, whose low frequencies it measures (as Ulichney 1993 and Heitz and Belcour 2019 for other masks).
#pragma once

#include <array>
#include <cstdint>

namespace penumbra {

inline constexpr std::uint32_t bluenoise_mask_size = 128;
inline constexpr int bluenoise_mask_bits = 6;  // of each of the two coordinates

// Row by row; the upper half of a word holds the first coordinate in its highest bits, the lower half the second.
extern const std::array<std::uint32_t, bluenoise_mask_size * bluenoise_mask_size> bluenoise_mask;

}  // namespace penumbra
