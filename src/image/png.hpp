// PNG (ISO/IEC 15948) in memory, with libpng. Writes RGB of 8 or 16 bits with the metadata as text and nothing that
// depends on the machine or the time, so the same picture gives the same bytes. Reads every kind of PNG, as RGB.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "image/quantize.hpp"

namespace penumbra {

// The bytes of a PNG file with `bits` (8 or 16) for each of r, g, b. Metadata become text chunks named `penumbra:key`.
// Throws FileError 70 when the image is empty or libpng refuses it.
std::vector<std::byte> encode_png(const Image& image, const Metadata& metadata, int bits, Rounding rounding);

// Whether the bytes begin like a PNG file.
bool is_png(std::span<const std::byte> bytes);

// The picture in a PNG file: values are n/255 or n/65535 without gamma, grey and palette become RGB, transparency is
// ignored. `name` is for the error message. Throws FileError 65 when the file is damaged or larger than 2^28 pixels.
ImageFile decode_png(std::span<const std::byte> bytes, const std::string& name);

}  // namespace penumbra
