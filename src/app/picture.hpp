// From a film to the picture a file holds: means, painted rectangles, layers, metadata.
#pragma once

#include <string>

#include "image/image.hpp"
#include "language/scene_file.hpp"
#include "rendering/film.hpp"

namespace penumbra {

// The film's picture with the scene's rectangles painted over it.
ImageFile develop(const Film& film, int full_width, int full_height, const std::vector<PaintedRect>& rects,
                  Metadata metadata);

}  // namespace penumbra
