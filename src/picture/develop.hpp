// From a film to the picture a file holds: means, exposure, painted rectangles, layers, metadata.
#pragma once

#include <vector>

#include "image/image.hpp"
#include "language/scene_file.hpp"
#include "rendering/film.hpp"

namespace penumbra {

// The film's picture with the scene's rectangles painted over it, times `exposure`.
ImageFile develop(const Film& film, int full_width, int full_height, const std::vector<PaintedRect>& rects,
                  double exposure, Metadata metadata);

// Multiplies all colours.
void expose(Image& image, double exposure);

}  // namespace penumbra
