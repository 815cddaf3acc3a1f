// From a film to the picture a file holds: means, exposure, painted rectangles, layers, metadata.
#pragma once

#include "image/image.hpp"
#include "picture/development.hpp"
#include "rendering/film.hpp"

namespace penumbra {

// The film's memory is freed layer by layer, as the picture takes its place.
ImageFile develop(Film film, const Development& development);

// Its colours alone.
Image develop_color(const Film& film, const Development& development);

// The factor of so many half steps: exact, and the same everywhere.
double exposure_factor(int halves);

// Multiplies all colours.
void expose(Image& image, double exposure);

}  // namespace penumbra
