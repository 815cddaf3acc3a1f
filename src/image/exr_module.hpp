// The code that uses OpenEXR, in a separate module that is loaded when the first EXR file is read or written, because
// loading OpenEXR takes as long as rendering a small picture.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace penumbra {

// Like encode_exr and decode_exr, but both throw std::exception with only the reason.
struct ExrModule {
  std::vector<std::byte> (*encode)(const ImageFile& file);
  ImageFile (*decode)(std::span<const std::byte> bytes, const std::string& name);
};

// The only function that the module exports.
extern "C" __attribute__((visibility("default"))) const ExrModule* penumbra_exr_module();

}  // namespace penumbra
