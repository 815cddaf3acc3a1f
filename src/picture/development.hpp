// Everything but the film that determines the files of a picture. A part of a picture carries it.
#pragma once

#include <string>
#include <vector>

#include "image/image.hpp"
#include "image/quantize.hpp"
#include "language/scene_file.hpp"

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

}  // namespace penumbra
