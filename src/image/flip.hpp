// The difference that a viewer perceives when flipping between two pictures in place: LDR-FLIP of Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proceedings of
// the ACM on Computer Graphics and Interactive Techniques 3(2), 2020. Implemented from the paper's equations.
#pragma once

#include <numbers>
#include <vector>

#include "image/image.hpp"

namespace penumbra {

// 0.7 m from a monitor 0.7 m wide with 3840 pixels across: the paper's default.
constexpr double flip_pixels_per_degree = 3840 * std::numbers::pi / 180;

// The FLIP error of each pixel, 0 (no difference) to 1. Colours are clamped to 0..1 and taken as display-referred sRGB.
// Both pictures have the same size.
std::vector<float> flip_map(const Image& reference, const Image& test,
                            double pixels_per_degree = flip_pixels_per_degree);

// The mean of the map.
double flip(const Image& reference, const Image& test);

}  // namespace penumbra
