// How far two pictures of the same size are apart, in plain numbers: the difference of each pixel, mean absolute error,
// RMSE and PSNR. Differences are on the scene's scale (a PNG's n/255). What is not finite matches its like (NaN to NaN,
// infinity to the same infinity); where it meets anything else the difference is infinite.
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

// The largest of the numbers that is finite; 0 for none.
float largest_finite(std::span<const float> differences);

// How many of the numbers are larger than the threshold; an infinite one is, whatever the threshold.
std::size_t count_beyond(std::span<const float> differences, float threshold);

struct ErrorFigures {
  double mean_absolute_error = 0;  // over all colour values of all pixels; infinite differences are left out
  double rmse = 0;                 // root of the mean squared difference over the same
  double psnr = 0;                 // dB: 20 log10(peak / rmse), peak = max(1, largest value); infinity when rmse is 0
};

ErrorFigures error_figures(const Image& a, const Image& b);

// Rec. 601 luma, 0.299 r + 0.587 g + 0.114 b, of colours clamped to 0..1 as a screen does.
std::vector<float> luma(const Image& image);

}  // namespace penumbra
