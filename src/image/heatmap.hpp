// A false-colour picture of where two pictures differ: from black over violet, red and orange to pale yellow, each
// colour lighter than the one before, so that it also reads in grey and for the colour-blind.
#pragma once

#include <vector>

#include "image/image.hpp"

namespace penumbra {

// The ramp's colour for t in 0..1; t beyond is clamped.
void heat_colour(float t, float rgb[3]);

// One pixel for each difference: black for 0, pale yellow for `scale` and more, infinite ones too.
Image heatmap(const std::vector<float>& differences, int width, int height, float scale);

}  // namespace penumbra
