#include "image/image_file.hpp"

#include <fmt/format.h>
#include <strings.h>
#include <sysexits.h>

#include "base/atomic_file.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"

namespace penumbra {
namespace {

ImageFormat required_format(const std::filesystem::path& path) {
  const ImageFormat format = format_of(path);
  if (format != ImageFormat::none) return format;
  throw FileError(EX_CANTCREAT,
                  fmt::format("cannot write `{}`: a picture's name must end in .png or .exr", path.string()));
}

}  // namespace

ImageFormat format_of(const std::filesystem::path& path) {
  if (path == standard_output) return ImageFormat::png;
  const std::filesystem::path ending = path.extension();
  if (::strcasecmp(ending.c_str(), ".png") == 0) return ImageFormat::png;
  return ::strcasecmp(ending.c_str(), ".exr") == 0 ? ImageFormat::exr : ImageFormat::none;
}

std::vector<std::byte> encode_image(const ImageFile& file, ImageFormat format, const Quantization& quantization) {
  switch (format) {
    case ImageFormat::png:
      return encode_png(file.image, file.metadata, quantization.bits, quantization.rounding);
    case ImageFormat::exr:
      return encode_exr(file);
    case ImageFormat::none:
      break;
  }
  throw FileError(EX_CANTCREAT, "cannot write a picture in a format that is neither PNG nor EXR");
}

void write_image(const std::filesystem::path& path, const ImageFile& file, const Quantization& quantization) {
  write_file_atomically(path, encode_image(file, required_format(path), quantization));
}

void try_to_write_image(const std::filesystem::path& path) {
  try {
    if (required_format(path) == ImageFormat::exr) load_exr_module();
    try_to_write(path);
  } catch (const FileError& error) {
    throw FileError(EX_CANTCREAT, error.what());
  }
}

ImageFile read_image(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = read_file(path, [](auto start) { return is_png(start) || is_exr(start); });
  if (is_png(bytes)) return decode_png(bytes, path.string());
  if (is_exr(bytes)) return decode_exr(bytes, path.string());
  throw FileError(EX_DATAERR, fmt::format("`{}` is neither a PNG nor an EXR file", path.string()));
}

}  // namespace penumbra
