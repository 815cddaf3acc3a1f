// The file ends with 8 bytes that hold the offset of the sums, and 8 that identify it as a part.
#include "app/merge/part_file.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "base/archive.hpp"
#include "base/say.hpp"
#include "image/exr.hpp"
#include "image/image_file.hpp"
#include "picture/develop.hpp"

namespace penumbra {
namespace {

constexpr std::string_view ending = "PENUPART";
constexpr std::size_t trailer_size = sizeof(std::uint64_t) + ending.size();
constexpr const char* key = "part-of-picture";
constexpr std::size_t longest_exr_header = 4096;  // that a part has

ImageFile preview(const PartHeader& header, const Film& film) {
  const TileGrid grid = header.tiles();
  Image image = make_image(grid.columns(), grid.rows());
  for (int tile = 0; tile < grid.count(); tile++) {
    if (!grid.has(header.shard, tile)) continue;
    const ZeroedVector<float> colors = film.cut(grid.tile(tile)).color();
    const std::size_t count = colors.size() / 3;
    const auto pixels = static_cast<float>(count);
    float* const mean = &image.rgb[3 * static_cast<std::size_t>(tile)];
    for (std::size_t i = 0; i < colors.size(); i++) mean[i % 3] += colors[i] / pixels;
  }
  return whole_picture(std::move(image), {{key, fmt::format("{}/{}", header.shard.index, header.shard.count)}});
}

bool ends_as_part(std::span<const std::byte> bytes) {
  return bytes.size() >= trailer_size &&
         std::equal(ending.begin(), ending.end(), bytes.end() - ending.size(),
                    [](char letter, std::byte byte) { return static_cast<std::byte>(letter) == byte; });
}

}  // namespace

std::vector<std::byte> encode_part_file(const PartHeader& header, const Film& film) {
  std::vector<std::byte> file = encode_exr(preview(header, film));
  const std::uint64_t start = file.size();
  ArchiveWriter whole(encode_part(header, film, std::move(file)));
  whole(start);
  whole.numbers(std::span(ending));
  return whole.take();
}

std::span<const std::byte> part_in_file(std::span<const std::byte> bytes, const std::string& name) {
  const auto fail = [&name](const char* why) { throw FileError(EX_DATAERR, fmt::format("`{}` {}", name, why)); };
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const bool began_as_part = is_exr(bytes) && text.substr(0, longest_exr_header).find(key) != text.npos;
  if (!began_as_part) fail("is not a part of a picture, as `penumbra render --shard` writes them");
  if (!ends_as_part(bytes)) fail("is a truncated part of a picture: its end is missing");
  std::uint64_t start = 0;
  ArchiveReader trailer(bytes.last(trailer_size));
  trailer(start);
  if (start > bytes.size() - trailer_size) fail("is a damaged part of a picture: the offset of its tiles is wrong");
  const auto at = static_cast<std::size_t>(start);
  return bytes.subspan(at, bytes.size() - trailer_size - at);
}

bool ends_as_part_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::array<char, ending.size()> last{};
  file.seekg(-static_cast<std::streamoff>(last.size()), std::ios::end);
  return file.read(last.data(), last.size()) && std::string_view(last.data(), last.size()) == ending;
}

PartFiles read_parts(const std::vector<std::string>& names) {
  PartFiles files;
  for (const std::string& name : names) {
    try {
      files.bytes.push_back(read_file(name));
      files.parts.emplace_back(part_in_file(files.bytes.back(), name), name);
    } catch (const FileError& error) {
      files.failures.push_back({name, error});
    }
  }
  return files;
}

void write_merged(const std::vector<Part>& parts, const std::vector<std::string>& outputs, bool quiet) {
  for (const std::string& output : outputs) try_to_write_image(output);
  const PartHeader& header = parts.front().header();
  Development development;
  try {
    development = development_from(header.development);
  } catch (const ArchiveError& error) {
    throw FileError(EX_DATAERR, fmt::format("`{}` is a damaged part: {}", parts.front().name(), error.what()));
  }
  const ImageFile image = develop(merge(parts), development);
  for (const std::string& output : outputs) {
    write_image(output, image, {development.bits, development.rounding});
    force_folder_of(output);  // its parts may be removed now
    if (!quiet) {
      say(fmt::format("{}: {}x{} pixels, from {} parts\n", output, header.crop.width(), header.crop.height(),
                      parts.size()));
    }
  }
}

}  // namespace penumbra
