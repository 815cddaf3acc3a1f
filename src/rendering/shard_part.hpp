// The tiles of one shard as bytes, and the parts of a picture put together: the film is that of a single render, to the
// bit.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "rendering/film.hpp"
#include "rendering/picture_key.hpp"
#include "rendering/plan.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {

struct PartHeader {
  PictureKey key;
  Shard shard;
  PixelRect crop;
  Layers layers;
  SampleCounts counts = SampleCounts::uniform;
  std::string development;  // what turns the film into a picture, as whoever wrote it wants it back

  TileGrid tiles() const { return tiles_of(crop, counts); }
};

// The film holds at least the shard's tiles.
std::vector<std::byte> encode_part(const PartHeader& header, const Film& film);

// A part that was read and found whole.
class Part {
 public:
  // Throws FileError 65, with `name` for the file's, where the bytes are damaged or no part. The bytes must outlive it.
  Part(std::span<const std::byte> bytes, std::string name);

  const PartHeader& header() const { return header_; }
  const std::string& name() const { return name_; }

  // Puts its tiles in their place in a film with the header's crop, layers and counts.
  void add_to(Film& film) const;

 private:
  std::span<const std::byte> bytes_;
  std::string name_;
  PartHeader header_;
};

// What keeps parts from being one picture, a sentence each: those of other pictures, those that are there twice, those
// that are missing. Empty if nothing does. There must be one part at least.
std::vector<std::string> problems_of(const std::vector<Part>& parts);

// The film of parts about which there is no problem.
Film merge(const std::vector<Part>& parts);

}  // namespace penumbra
