// How much two pictures of the same size differ: the difference of each pixel, mean absolute error, RMSE and PSNR in
// plain numbers, structural similarity, and what a viewer perceives. Differences are on the scale of the scene (n/255
// for a PNG). Non-finite values match their like (NaN and NaN, infinity and the same infinity); their difference from
// anything else is infinite.
#pragma once

#include <cstddef>
#include <numbers>
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

// Structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to
// Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004.
//
// The mean SSIM index of the paper's equations 13 and 17, on luma clamped to 0..1, with its parameters: an 11 x 11
// Gaussian window of standard deviation 1.5, K1 = 0.01, K2 = 0.03, L = 1, over all windows that lie within the picture.
// In a picture with fewer than 11 rows or columns the window shrinks to fit. Both pictures have the same size.
// 1 for equal pictures, down to -1.
double ssim(const Image& a, const Image& b);

// The difference that a viewer perceives when flipping between two pictures in place: LDR-FLIP of Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proceedings of
// the ACM on Computer Graphics and Interactive Techniques 3(2), 2020. Implemented from the paper's equations.

// 0.7 m from a monitor 0.7 m wide with 3840 pixels across: the paper's default.
constexpr double flip_pixels_per_degree = 3840 * std::numbers::pi / 180;

// The FLIP error of each pixel, 0 (no difference) to 1. Colours are clamped to 0..1 and taken as display-referred sRGB.
// Both pictures have the same size.
std::vector<float> flip_map(const Image& reference, const Image& test,
                            double pixels_per_degree = flip_pixels_per_degree);

// The mean of the map.
double flip(const Image& reference, const Image& test);

}  // namespace penumbra
