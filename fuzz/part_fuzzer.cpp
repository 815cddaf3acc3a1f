// Part files from arbitrary bytes: refused, or merged into a picture.
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "app/merge/part_file.hpp"
#include "base/atomic_file.hpp"
#include "invariants.hpp"
#include "picture/develop.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  std::vector<Part> parts;
  try {
    parts.emplace_back(part_in_file(std::as_bytes(std::span(data, size)), "p"), "p");
  } catch (const FileError& error) {
    require(error.exit_code == 65 && std::string_view(error.what()).starts_with("`p` is "));
    return 0;
  }
  const std::vector<std::string> problems = problems_of(parts);
  require(problems.empty() == (parts[0].header().shard.count == 1));
  parts.push_back(parts[0]);
  require(!problems_of(parts).empty());
  parts.pop_back();
  if (!problems.empty()) return 0;
  Film film = merge(parts);
  const PixelRect crop = film.crop();
  try {
    const ImageFile image = develop(std::move(film), development_from(parts[0].header().development));
    require(image.image.rgb.size() == 3 * static_cast<std::size_t>(crop.width()) * crop.height());
  } catch (const ArchiveError&) {
  }
  return 0;
}
