// Turns a film into the picture that a file holds: means, exposure, painted rectangles, layers, metadata. A part of a
// picture carries everything but the film that this needs.
#pragma once

#include <string>
#include <vector>

#include "image/image.hpp"
#include "image/quantize.hpp"
#include "language/scene_file.hpp"
#include "rendering/film.hpp"

namespace penumbra {

// The most half stops of exposure, in either direction.
inline constexpr int most_exposure_halves = 40;

struct Development {
  int full_width = 0, full_height = 0;
  std::vector<PaintedRect> rects;
  Metadata metadata;
  int exposure_halves = 0;
  int bits = 8;  // per channel in a PNG
  Rounding rounding = Rounding::nearest;
};

// To bytes and back. Throws ArchiveError if the bytes are not a valid Development.
std::string to_bytes(const Development& development);
Development development_from(const std::string& bytes);

// Frees the film's memory as the picture replaces it: the two together never take more than the film.
ImageFile develop(Film film, const Development& development);

// Only the colours.
Image develop_color(const Film& film, const Development& development);

// The factor of `halves` half stops: the same bits on every machine.
double exposure_factor(int halves);

// Multiplies all colours.
void expose(Image& image, double exposure);

}  // namespace penumbra
