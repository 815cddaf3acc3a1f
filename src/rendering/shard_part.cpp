#include "rendering/shard_part.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "rendering/sealed_file.hpp"

namespace penumbra {
namespace {

constexpr int largest_side = 1 << 17;
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

template <class Archive, class Header>
void exchange_header(Archive& archive, Header& header) {
  exchange_key(archive, header.key);
  archive(header.shard.index);
  archive(header.shard.count);
  for (auto* edge : {&header.crop.x0, &header.crop.y0, &header.crop.x1, &header.crop.y1}) archive(*edge);
  auto& layers = header.layers;
  for (auto* layer : {&layers.depth, &layers.normal, &layers.albedo, &layers.variance, &layers.samples}) {
    archive(*layer);
  }
  bool own_counts = header.counts == SampleCounts::per_pixel;
  archive(own_counts);
  archive(header.development);
  if constexpr (Archive::reads) {
    header.counts = own_counts ? SampleCounts::per_pixel : SampleCounts::uniform;
    const Crop& c = header.crop;
    bool is_window =
        c.x0 >= 0 && c.y0 >= 0 && c.x0 < c.x1 && c.y0 < c.y1 && c.x1 <= largest_side && c.y1 <= largest_side;
    is_window = is_window && std::int64_t{c.width()} * c.height() <= most_pixels;
    if (!is_window) throw ArchiveError("there is no such window of a picture");
    const Shard& shard = header.shard;
    if (shard.count < 1 || shard.count > most_shards || shard.index < 0 || shard.index >= shard.count) {
      throw ArchiveError("there is no such shard");
    }
  }
}

std::size_t pixels_of(const Crop& tile) {
  return static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height());
}

// "3, 7-9, 12", and no more than some of them.
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
  if (const auto differs = difference(here.key, there.key)) {
    if (differs->name == "version") {
      return fmt::format("penumbra {} wrote it, and {} the others", differs->here, differs->there);
    }
    if (differs->name == "scene") return "its scene, or a file that this reads, is not the same";
    if (differs->name == "picture") {
      return fmt::format("it is of picture {} of the scene, not of {}", differs->here, differs->there);
    }
    return fmt::format("its `{}` is {}, and {} in the others", differs->name, differs->here, differs->there);
  }
  if (here.shard.count != there.shard.count) {
    return fmt::format("it is one of {} shards, not of {}", here.shard.count, there.shard.count);
  }
  const bool same = here.crop == there.crop && here.layers == there.layers && here.counts == there.counts &&
                    here.development == there.development;
  return same ? "" : "it is not to be developed as the others are";
}

// Of the picture that most parts are of; the first of several such.
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

std::vector<std::byte> encode_part(const PartHeader& header, const Film& film) {
  SealedWriter file(FileKind::part);
  ArchiveWriter block;
  exchange_header(block, header);
  file.add(block.bytes());
  const TileGrid grid = header.tiles();
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
  file.read(file.next(), [this](ArchiveReader& archive) { exchange_header(archive, header_); });
  const TileGrid grid = header_.tiles();
  const std::size_t bytes_per_pixel = Film::bytes_per_pixel(header_.layers, header_.counts);
  for (int tile = 0; tile < grid.count(); tile++) {
    if (!grid.has(header_.shard, tile)) continue;
    const auto block = file.next();
    if (block.size() != sizeof tile + pixels_of(grid.tile(tile)) * bytes_per_pixel)
      file.fail("it is not of a tile's size");
    int found = 0;
    ArchiveReader archive(block);
    archive(found);
    if (found != tile) file.fail("it is not of the tile whose turn it is");
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

std::vector<std::string> complaints_about(const std::vector<Part>& parts) {
  std::vector<std::string> complaints;
  const PartHeader& common = most_common(parts);
  std::vector<const Part*> found(static_cast<std::size_t>(common.shard.count));
  for (const Part& part : parts) {
    if (const std::string why = difference_in_words(part.header(), common); !why.empty()) {
      complaints.push_back(fmt::format("`{}` is a part of another picture: {}", part.name(), why));
      continue;
    }
    const Part*& place = found[static_cast<std::size_t>(part.header().shard.index)];
    if (place) {
      complaints.push_back(
          fmt::format("shard {} is there twice: `{}` and `{}`", part.header().shard.index, place->name(), part.name()));
    }
    place = &part;
  }
  std::vector<int> missing;
  for (int i = 0; i < common.shard.count; i++) {
    if (!found[static_cast<std::size_t>(i)]) missing.push_back(i);
  }
  if (!missing.empty()) {
    complaints.push_back(fmt::format("of {} shards, from 0, {} missing: {}", common.shard.count,
                                     missing.size() == 1 ? "one is" : fmt::format("{} are", missing.size()),
                                     in_words(missing)));
  }
  return complaints;
}

Film merge(const std::vector<Part>& parts) {
  const PartHeader& header = parts.front().header();
  Film film(header.crop, header.layers, header.counts);
  for (const Part& part : parts) part.add_to(film);
  return film;
}

}  // namespace penumbra
