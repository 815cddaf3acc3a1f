// Structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to
// Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004.
#pragma once

#include "image/image.hpp"

namespace penumbra {

// The mean SSIM index of the paper's equations 13 and 17, on luma clamped to 0..1, with its parameters: an 11 x 11
// Gaussian window of standard deviation 1.5, K1 = 0.01, K2 = 0.03, L = 1, over all windows that lie within the picture.
// In a picture with fewer than 11 rows or columns the window shrinks to fit. Both pictures have the same size.
// 1 for equal pictures, down to -1.
double ssim(const Image& a, const Image& b);

}  // namespace penumbra
