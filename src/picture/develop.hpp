// Turns a film into the picture that a file holds: means, exposure, painted rectangles, layers, metadata.
#pragma once

#include "image/image.hpp"
#include "picture/development.hpp"
#include "rendering/film.hpp"

namespace penumbra {

// Frees the film's memory layer by layer, as the picture replaces it.
ImageFile develop(Film film, const Development& development);

// Only the colours.
Image develop_color(const Film& film, const Development& development);

// The factor of `halves` half stops: the same bits on every machine.
double exposure_factor(int halves);

// Multiplies all colours.
void expose(Image& image, double exposure);

}  // namespace penumbra
