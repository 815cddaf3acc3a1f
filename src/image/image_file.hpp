// Pictures to and from files, whatever the format: the door that the rest of the program uses. Writing is atomic (see
// base/atomic_file.hpp) and the same picture gives the same bytes, always.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "image/image.hpp"
#include "image/quantize.hpp"

namespace penumbra {

enum class ImageFormat { none, png, exr };

// The format that the ending of a file name asks for, in whatever case; none for any other ending.
ImageFormat format_of(const std::filesystem::path& path);

// How a PNG holds the colours; an EXR holds them as they are.
struct Quantization {
  int bits = 8;  // 8 or 16
  Rounding rounding = Rounding::nearest;
};

// The file's bytes. The layers of a PNG are left out. Throws FileError 73 for ImageFormat::none, 70 for sizes that do
// not agree with each other.
std::vector<std::byte> encode_image(const ImageFile& file, ImageFormat format, const Quantization& quantization);

// Writes a picture in the format that the name asks for. Throws FileError, 73 or 74.
void write_image(const std::filesystem::path& path, const ImageFile& file, const Quantization& quantization = {});

// Reads a PNG or an EXR, told apart by their first bytes. Throws FileError: 66 when there is no such file, 74 when it
// cannot be read, 65 when it is no picture or a damaged one.
ImageFile read_image(const std::filesystem::path& path);

}  // namespace penumbra
