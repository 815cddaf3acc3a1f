// What makes the files of a picture out of its film: all but the film itself. A part of a picture carries it.
#pragma once

#include <string>
#include <vector>

#include "image/image.hpp"
#include "image/quantize.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

// The most half steps of exposure, either way.
inline constexpr int most_exposure_halves = 40;

struct Development {
  int full_width = 0, full_height = 0;
  std::vector<PaintedRect> rects;
  Metadata metadata;
  int exposure_halves = 0;
  int bits = 8;  // for each colour in a PNG
  Rounding rounding = Rounding::nearest;
};

// As bytes and back. Throws ArchiveError where the bytes cannot be one.
std::string to_bytes(const Development& development);
Development development_from(const std::string& bytes);

}  // namespace penumbra
