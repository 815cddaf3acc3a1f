// Reads and writes picture files, whatever the format: the interface for the rest of the program. Writing is atomic
// (see base/atomic_file.hpp), and the same picture always gives the same bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "image/image.hpp"
#include "image/quantize.hpp"

namespace penumbra {

enum class ImageFormat { none, png, exr };

// A picture of this name is a PNG on standard output.
inline constexpr const char* standard_output = "/dev/stdout";

// The format of a file name by its ending, in upper or lower case; none for any other ending.
ImageFormat format_of(const std::filesystem::path& path);

// How a PNG stores colours; an EXR stores them as they are.
struct Quantization {
  int bits = 8;  // 8 or 16
  Rounding rounding = Rounding::nearest;
};

// The bytes of the file. A PNG omits the layers. Throws FileError 73 for ImageFormat::none, 70 for sizes that do not
// agree with each other.
std::vector<std::byte> encode_image(const ImageFile& file, ImageFormat format, const Quantization& quantization);

// Writes a picture in the format of its name. Throws FileError, 73 or 74.
void write_image(const std::filesystem::path& path, const ImageFile& file, const Quantization& quantization = {});

// Finds out, before the picture is made, what would keep write_image from beginning: its name, its place, the library
// that it needs. Throws FileError 73.
void try_to_write_image(const std::filesystem::path& path);

// Reads a PNG or an EXR, distinguished by their first bytes. Throws FileError: 66 when there is no such file, 74 when
// it cannot be read, 65 when it is not a picture or is damaged.
ImageFile read_image(const std::filesystem::path& path);

}  // namespace penumbra
