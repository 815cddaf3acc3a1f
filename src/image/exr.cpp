#include "image/exr.hpp"

#include <sysexits.h>

#include <array>
#include <cstring>

#include "base/atomic_file.hpp"
#include "base/shared_library.hpp"
#include "image/exr_module.hpp"

namespace penumbra {
namespace {

const ExrModule& exr_module() {
  static const ExrModule* const module = [] {
    try {
      const SharedLibrary file("libpenumbra_exr.so", "it belongs beside the program, and needs libopenexr-3-1-30");
      decltype(&penumbra_exr_module) get = nullptr;
      file.load("penumbra_exr_module", get);
      return get();
    } catch (const std::runtime_error& error) {
      throw FileError(EX_SOFTWARE, error.what());
    }
  }();
  return *module;
}

}  // namespace

std::vector<std::byte> encode_exr(const ImageFile& file) { return exr_module().encode(file); }

bool is_exr(std::span<const std::byte> bytes) {
  constexpr std::array<unsigned char, 4> magic{0x76, 0x2f, 0x31, 0x01};
  return bytes.size() >= 4 && std::memcmp(bytes.data(), magic.data(), 4) == 0;
}

ImageFile decode_exr(std::span<const std::byte> bytes, const std::string& name) {
  return exr_module().decode(bytes, name);
}

}  // namespace penumbra
