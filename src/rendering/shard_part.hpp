// The tiles of one shard as bytes, and the merging of such parts: the film is that of a single render, to the bit.
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
  std::string development;  // how to turn the film into a picture; opaque here

  TileGrid tiles() const { return tiles_of(crop, counts); }
};

// The bytes of the part after those of `before`. The film must have at least the shard's tiles.
std::vector<std::byte> encode_part(const PartHeader& header, const Film& film, std::vector<std::byte> before = {});

// A part that was read and is intact.
class Part {
 public:
  // Throws FileError 65, which calls the file `name`, if the bytes are damaged or not a part. They must outlive it.
  Part(std::span<const std::byte> bytes, std::string name);

  const PartHeader& header() const { return header_; }
  const std::string& name() const { return name_; }

  // Copies its tiles into a film with the header's crop, layers and counts.
  void add_to(Film& film) const;

 private:
  std::span<const std::byte> bytes_;
  std::string name_;
  PartHeader header_;
};

// Why the parts do not make up one picture, a sentence each: parts of other pictures, duplicates, missing parts. Empty
// if they do. There must be at least one part.
std::vector<std::string> problems_of(const std::vector<Part>& parts);

// The film of parts without problems_of().
Film merge(const std::vector<Part>& parts);

}  // namespace penumbra
