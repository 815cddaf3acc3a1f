// The part of EXR files that is built on OpenEXR, as a module of its own: OpenEXR is loaded when the first EXR file is
// read or written, because loading it takes as long as a small picture does. The module and the program have C++
// libraries of their own, so no exception goes from one to the other.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace penumbra {

// As encode_exr and decode_exr, with the result in the last parameter. They answer what went wrong, or nothing.
struct ExrModule {
  std::optional<std::string> (*encode)(const ImageFile& file, std::vector<std::byte>& bytes) noexcept;
  std::optional<std::string> (*decode)(std::span<const std::byte> bytes, const std::string& name,
                                       ImageFile& file) noexcept;
};

// The only function that the module shows.
extern "C" __attribute__((visibility("default"))) const ExrModule* penumbra_exr_module();

}  // namespace penumbra
