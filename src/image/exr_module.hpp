// The part of EXR files that is built on OpenEXR, as a module of its own: OpenEXR is loaded when the first EXR file is
// read or written, because loading it takes as long as a small picture does.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace penumbra {

// As encode_exr and decode_exr. Both throw std::exception with the reason alone.
struct ExrModule {
  std::vector<std::byte> (*encode)(const ImageFile& file);
  ImageFile (*decode)(std::span<const std::byte> bytes, const std::string& name);
};

// The only function that the module shows.
extern "C" __attribute__((visibility("default"))) const ExrModule* penumbra_exr_module();

}  // namespace penumbra
