// How much two pictures of the same size differ, in plain numbers: the difference of each pixel, mean absolute error,
// RMSE and PSNR. Differences are on the scale of the scene (n/255 for a PNG). Non-finite values match their like (NaN
// and NaN, infinity and the same infinity); their difference from anything else is infinite.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/image.hpp"

namespace penumbra {

// |a - b|, in float as the values are.
float difference(float a, float b);

// The largest difference among the three colours of each pixel.
std::vector<float> pixel_differences(const Image& a, const Image& b);

// The largest finite number; 0 if there is none.
float largest_finite(std::span<const float> differences);

// How many of the numbers exceed the threshold; an infinite one always does.
std::size_t count_beyond(std::span<const float> differences, float threshold);

// How many pixels have a colour value that is NaN or infinite.
std::size_t count_not_finite(const Image& image);

struct ErrorFigures {
  double mean_absolute_error = 0;  // over all colour values of all pixels; infinite if one difference is
  double rmse = 0;                 // root of the mean squared difference over the same
  double psnr = 0;                 // dB: 20 log10(peak / rmse), peak = max(1, largest finite value)
};

ErrorFigures error_figures(const Image& a, const Image& b);

// Rec. 601 luma, 0.299 r + 0.587 g + 0.114 b, of colours clamped to 0..1 as a screen does.
std::vector<float> luma(const Image& image);

}  // namespace penumbra
