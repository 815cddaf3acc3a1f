// Pictures from arbitrary bytes, as `compare` reads them: refused, or the same as themselves. The checksums of a PNG's
// chunks are put right first: a fuzzer would never get past one.
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/atomic_file.hpp"
#include "image/comparison.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"
#include "invariants.hpp"

namespace {

using namespace penumbra;

constexpr std::size_t most_values = std::size_t{3} << 14;  // of pictures that are also compared

// A chunk: length in four bytes, the largest first; name in four bytes; content; checksum of name and content.
void correct_checksums(std::vector<std::uint8_t>& bytes) {
  const auto number = [&](std::size_t at) {
    return std::size_t{bytes[at]} << 24 | std::size_t{bytes[at + 1]} << 16 | std::size_t{bytes[at + 2]} << 8 |
           bytes[at + 3];
  };
  for (std::size_t at = 8; bytes.size() >= at + 12;) {
    const std::size_t length = number(at);
    if (length > bytes.size() - at - 12) return;
    const auto sum = ::crc32(0, &bytes[at + 4], static_cast<unsigned>(length + 4));
    for (std::size_t i = 0; i < 4; i++) bytes[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at += length + 12;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> copy(data, data + size);
  const std::span<const std::byte> bytes = std::as_bytes(std::span(copy));
  if (is_png(bytes)) correct_checksums(copy);
  if (!is_png(bytes) && !is_exr(bytes)) return 0;
  ImageFile file;
  try {
    file = is_png(bytes) ? decode_png(bytes, "p") : decode_exr(bytes, "p");
  } catch (const FileError& error) {
    require(error.exit_code == 65 && std::string_view(error.what()).starts_with("`p` is "));
    return 0;
  }
  const Image& image = file.image;
  require(image.width > 0 && image.height > 0);
  require(image.rgb.size() == 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (const Channel& layer : file.layers) require(3 * layer.values.size() == image.rgb.size());
  if (image.rgb.size() > most_values) return 0;
  require(can_compare(file, file));
  const Comparison comparison = compare(file, file, {});
  require(comparison.verdict == Verdict::same && comparison.pixels_beyond == 0);
  return 0;
}
