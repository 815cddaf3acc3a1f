// A part of a picture as a file: an EXR for the eye, with one pixel for each tile, and after its end the shard's exact
// sums (rendering/shard_part.hpp), which readers of EXR files do not see.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "rendering/shard_part.hpp"

namespace penumbra {

std::vector<std::byte> encode_part_file(const PartHeader& header, const Film& film);

// The bytes of the part in those of a file. Throws FileError 65, with `name` for the file's, where there is none or the
// file is cut off.
std::span<const std::byte> part_in_file(std::span<const std::byte> bytes, const std::string& name);

// Whether the file ends as a part does: a look at a few bytes, for those who need not know more.
bool ends_as_part_file(const std::filesystem::path& path);

}  // namespace penumbra
