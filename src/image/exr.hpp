// OpenEXR in memory: 32-bit float colours, layers as further channels, the crop as data window, the full picture as
// display window, metadata as text attributes, ZIP compression. The same picture gives the same bytes.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace penumbra {

// The bytes of an EXR file with channels R, G, B and the layers. Metadata become attributes named `penumbra:key`.
// Throws FileError 70 when sizes do not agree or OpenEXR refuses the picture.
std::vector<std::byte> encode_exr(const ImageFile& file);

// Loads the module below, which encoding and decoding otherwise do when they first need it. Throws FileError 70.
void load_exr_module();

// Whether the bytes begin like an EXR file.
bool is_exr(std::span<const std::byte> bytes);

// Decodes an EXR file of one part, with scan lines or tiles of half, float or integer numbers: R, G, B (or grey from Y)
// become the image, all other full-resolution channels the layers. `name` is for the error message. Throws FileError 65
// when the file is damaged, has neither colours nor grey, or is larger than 2^28 pixels.
ImageFile decode_exr(std::span<const std::byte> bytes, const std::string& name);

// The code that uses OpenEXR is in a separate module, exr_module.cpp, that is loaded when the first EXR file is read or
// written, because loading OpenEXR takes as long as rendering a small picture. Like encode_exr and decode_exr, but both
// throw std::exception with only the reason.
struct ExrModule {
  std::vector<std::byte> (*encode)(const ImageFile& file);
  ImageFile (*decode)(std::span<const std::byte> bytes, const std::string& name);
};

// The only function that the module exports.
extern "C" __attribute__((visibility("default"))) const ExrModule* penumbra_exr_module();

}  // namespace penumbra
