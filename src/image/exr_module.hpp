// The part of EXR files that is built on OpenEXR, as a module of its own: OpenEXR is loaded when the first EXR file is
// read or written, because loading it takes as long as a small picture does. The module and the program have C++
// libraries of their own, so no exception goes from one to the other.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace penumbra {

// What a FileError tells; no exit code where nothing went wrong.
struct ExrFailure {
  int exit_code = 0;
  std::string sentence;
};

// As encode_exr and decode_exr, with the answer in the last parameter.
struct ExrModule {
  ExrFailure (*encode)(const ImageFile& file, std::vector<std::byte>& bytes);
  ExrFailure (*decode)(std::span<const std::byte> bytes, const std::string& name, ImageFile& file);
};

// The only function that the module shows.
extern "C" const ExrModule* penumbra_exr_module();

}  // namespace penumbra
