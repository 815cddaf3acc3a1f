// A part of a picture as a file: a preview as EXR, with one pixel for each tile, and behind its end the shard's exact
// sums (rendering/shard_part.hpp), which readers of EXR files ignore.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "rendering/shard_part.hpp"

namespace penumbra {

std::vector<std::byte> encode_part_file(const PartHeader& header, const Film& film);

// Finds the bytes of the part in those of the file `name`. Throws FileError 65 if there is no part or the file is
// truncated.
std::span<const std::byte> part_in_file(std::span<const std::byte> bytes, const std::string& name);

// Whether the file ends as a part does: a cheap check of a few bytes.
bool ends_as_part_file(const std::filesystem::path& path);

}  // namespace penumbra
