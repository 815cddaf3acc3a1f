// A false-colour picture of where two pictures differ: from black through violet, red and orange to pale yellow, each
// colour lighter than the one before, so that it also works in grey and for colour-blind viewers.
#pragma once

#include <vector>

#include "image/image.hpp"

namespace penumbra {

// The ramp's colour for t, which is clamped to 0..1.
void heat_colour(float t, float rgb[3]);

// One pixel per difference: black for 0, pale yellow for `scale` and more, including infinity.
Image heatmap(const std::vector<float>& differences, int width, int height, float scale);

}  // namespace penumbra
