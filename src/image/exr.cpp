#include "image/exr.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <array>
#include <cstring>

#include "base/atomic_file.hpp"
#include "base/shared_library.hpp"
#include "image/limits.hpp"

namespace penumbra {
namespace {

const ExrModule& exr_module() {
  static const ExrModule* const module = [] {
    try {
      const SharedLibrary file("libpenumbra_exr.so", "it belongs beside the program and needs OpenEXR");
      decltype(&penumbra_exr_module) get = nullptr;
      file.load("penumbra_exr_module", get);
      return get();
    } catch (const std::runtime_error& error) {
      throw FileError(EX_SOFTWARE, error.what());
    }
  }();
  return *module;
}

void require_agreement(const ImageFile& file) {
  require_image_size(file.image.width, file.image.height, file.image.rgb.size(), 3);
  for (const Channel& layer : file.layers) {
    require_image_size(file.image.width, file.image.height, layer.values.size(), 1);
  }
  require_metadata_keys(file.metadata);
  const bool fits = file.window.width() == file.image.width && file.window.height() == file.image.height &&
                    file.full_width > 0 && file.full_height > 0;
  if (!fits) throw FileError(EX_SOFTWARE, "the window of a picture does not have the picture's size");
}

}  // namespace

void load_exr_module() { exr_module(); }

std::vector<std::byte> encode_exr(const ImageFile& file) {
  require_agreement(file);
  const ExrModule& module = exr_module();
  try {
    return module.encode(file);
  } catch (const std::exception& error) {
    throw FileError(EX_SOFTWARE, fmt::format("cannot make an EXR: {}", error.what()));
  }
}

bool is_exr(std::span<const std::byte> bytes) {
  constexpr std::array<unsigned char, 4> magic{0x76, 0x2f, 0x31, 0x01};
  return bytes.size() >= 4 && std::memcmp(bytes.data(), magic.data(), 4) == 0;
}

ImageFile decode_exr(std::span<const std::byte> bytes, const std::string& name) {
  const ExrModule& module = exr_module();
  try {
    return module.decode(bytes, name);
  } catch (const std::exception& error) {
    throw FileError(EX_DATAERR, fmt::format("`{}` is not a valid EXR file: {}", name, error.what()));
  }
}

}  // namespace penumbra
