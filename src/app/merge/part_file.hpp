// A part of a picture as a file: a preview as EXR, with one pixel for each tile, and behind its end the shard's exact
// sums (rendering/shard_part.hpp), which readers of EXR files ignore.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/atomic_file.hpp"
#include "rendering/shard_part.hpp"

namespace penumbra {

std::vector<std::byte> encode_part_file(const PartHeader& header, const Film& film);

// Finds the bytes of the part in those of the file `name`. Throws FileError 65 if there is no part or the file is
// truncated.
std::span<const std::byte> part_in_file(std::span<const std::byte> bytes, const std::string& name);

// Whether the file ends as a part does: a cheap check of a few bytes.
bool ends_as_part_file(const std::filesystem::path& path);

// The parts of a picture from their files.
struct PartFiles {
  struct Failure {
    std::string name;
    FileError error;
  };

  std::vector<std::vector<std::byte>> bytes;  // the parts point into them
  std::vector<Part> parts;                    // the intact ones
  std::vector<Failure> failures;              // the others
};

PartFiles read_parts(const std::vector<std::string>& names);

// Merges parts without problems_of() and writes their picture. Throws FileError.
void write_merged(const std::vector<Part>& parts, const std::vector<std::string>& outputs, bool quiet);

}  // namespace penumbra
