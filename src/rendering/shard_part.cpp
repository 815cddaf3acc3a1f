#include "rendering/shard_part.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "rendering/sealed_file.hpp"
#include "scene/settings.hpp"

namespace penumbra {
namespace {

template <class Archive>
void serialize(Archive& archive, Archived<Archive, PartHeader>& header) {
  serialize(archive, header.key);
  archive(header.shard.index);
  archive(header.shard.count);
  for (auto* edge : {&header.crop.x0, &header.crop.y0, &header.crop.x1, &header.crop.y1}) archive(*edge);
  for (const LayerRow& row : layer_table) {
    bool wanted = header.layers.has(row.layer);
    archive(wanted);
    if constexpr (Archive::reads) {
      if (wanted) header.layers.add(row.layer);
    }
  }
  serialize_enum(archive, header.counts, SampleCounts::per_pixel);
  archive(header.development);
  if constexpr (Archive::reads) {
    const PixelRect& c = header.crop;
    const bool is_crop = c.x0 >= 0 && c.y0 >= 0 && c.x0 < c.x1 && c.y0 < c.y1 && c.x1 <= most_side &&
                         c.y1 <= most_side && c.pixel_count() <= most_pixels;
    if (!is_crop) throw ArchiveError("the crop is out of range");
    const Shard& shard = header.shard;
    if (shard.count < 1 || shard.count > most_shards || shard.index < 0 || shard.index >= shard.count) {
      throw ArchiveError("the shard is out of range");
    }
  }
}

// "3, 7-9, 12"; a long list ends with "and N more".
std::string in_words(const std::vector<int>& numbers) {
  constexpr std::size_t most_words = 20;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) end++;
    if (words.size() == most_words) {
      words.push_back(fmt::format("and {} more", numbers.size() - i));
      break;
    }
    words.push_back(end - i == 1 ? fmt::format("{}", numbers[i]) : fmt::format("{}-{}", numbers[i], numbers[end - 1]));
    i = end;
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

// How a part's picture differs from another's; empty if it does not.
std::string difference_in_words(const PartHeader& here, const PartHeader& there) {
  if (std::string why = difference(here.key, there.key, "in the others"); !why.empty()) return why;
  if (here.shard.count != there.shard.count) {
    return fmt::format("it is one of {} shards, not of {}", here.shard.count, there.shard.count);
  }
  const bool same = here.crop == there.crop && here.layers == there.layers && here.counts == there.counts &&
                    here.development == there.development;
  return same ? "" : "its crop, layers or output options differ from the others";
}

// The header of the picture that most parts belong to; of the first one in a tie.
const PartHeader& most_common(const std::vector<Part>& parts) {
  const auto relatives = [&parts](const Part& part) {
    return std::count_if(parts.begin(), parts.end(), [&part](const Part& other) {
      return difference_in_words(other.header(), part.header()).empty();
    });
  };
  const Part* best = &parts.front();
  auto most = relatives(*best);
  for (const Part& part : parts) {
    if (2 * most > static_cast<std::ptrdiff_t>(parts.size())) break;
    if (const auto count = relatives(part); count > most) {
      best = &part;
      most = count;
    }
  }
  return best->header();
}

}  // namespace

std::vector<std::byte> encode_part(const PartHeader& header, const Film& film, std::vector<std::byte> before) {
  SealedWriter file(FileKind::part, std::move(before));
  ArchiveWriter block;
  serialize(block, header);
  file.add(block.bytes());
  const TileGrid grid = header.tiles();
  std::size_t tiles = 0, largest_tile = 0;
  for (int tile = 0; tile < grid.count(); tile++) {
    if (!grid.has(header.shard, tile)) continue;
    tiles++;
    largest_tile = std::max(largest_tile, grid.tile(tile).pixel_count());
  }
  file.expect(tiles, sizeof(int) + largest_tile * Film::bytes_per_pixel(film.layers()));
  for (int tile = 0; tile < grid.count(); tile++) {
    if (!grid.has(header.shard, tile)) continue;
    block.clear();
    block(tile);
    film.write(block, grid.tile(tile));
    file.add(block.bytes());
  }
  return file.finish();
}

Part::Part(std::span<const std::byte> bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {
  SealedReader file(bytes_, FileKind::part, name_);
  file.read(file.next(), [this](ArchiveReader& archive) { serialize(archive, header_); });
  const TileGrid grid = header_.tiles();
  const std::size_t bytes_per_pixel = Film::bytes_per_pixel(header_.layers);
  for (int tile = 0; tile < grid.count(); tile++) {
    if (!grid.has(header_.shard, tile)) continue;
    const auto block = file.next();
    if (block.size() != sizeof tile + grid.tile(tile).pixel_count() * bytes_per_pixel)
      file.fail("it does not have the size of its tile");
    int found = 0;
    ArchiveReader archive(block);
    archive(found);
    if (found != tile) file.fail("it is not the shard's next tile");
  }
  if (!file.next().empty()) file.fail("there are more tiles than the shard has");
}

void Part::add_to(Film& film) const {
  SealedReader file(bytes_, FileKind::part, name_);
  file.next();
  const TileGrid grid = header_.tiles();
  for (auto block = file.next(); !block.empty(); block = file.next()) {
    file.read(block, [&](ArchiveReader& archive) {
      int tile = 0;
      archive(tile);
      film.read(archive, grid.tile(tile));
    });
  }
}

std::vector<std::string> problems_of(const std::vector<Part>& parts) {
  std::vector<std::string> problems;
  const PartHeader& common = most_common(parts);
  std::vector<const Part*> found(static_cast<std::size_t>(common.shard.count));
  for (const Part& part : parts) {
    if (const std::string why = difference_in_words(part.header(), common); !why.empty()) {
      problems.push_back(fmt::format("`{}` is a part of another picture: {}", part.name(), why));
      continue;
    }
    const Part*& place = found[static_cast<std::size_t>(part.header().shard.index)];
    if (place) {
      problems.push_back(
          fmt::format("shard {} occurs twice: `{}` and `{}`", part.header().shard.index, place->name(), part.name()));
    }
    place = &part;
  }
  std::vector<int> missing;
  for (int i = 0; i < common.shard.count; i++) {
    if (!found[static_cast<std::size_t>(i)]) missing.push_back(i);
  }
  if (!missing.empty()) {
    problems.push_back(fmt::format("of {} shards, numbered from 0, {} missing: {}", common.shard.count,
                                   missing.size() == 1 ? "one is" : fmt::format("{} are", missing.size()),
                                   in_words(missing)));
  }
  return problems;
}

Film merge(const std::vector<Part>& parts) {
  const PartHeader& header = parts.front().header();
  Film film(header.crop, header.layers, header.counts);
  for (const Part& part : parts) part.add_to(film);
  return film;
}

}  // namespace penumbra
