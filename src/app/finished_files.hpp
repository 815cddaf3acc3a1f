// Which files of an animation an earlier run has finished: every finished one tells what it was made of.
#pragma once

#include <filesystem>
#include <string>

#include "picture/development.hpp"
#include "rendering/picture_key.hpp"
#include "rendering/shard.hpp"

namespace penumbra {

// The key of a picture's metadata that holds its content_key().
inline constexpr const char* content_entry = "content";

// A hash, as text, of all that the file of a picture is made of: the version, the files of the scene, the options.
std::string content_key(const PictureKey& key, const Development& development);

// Whether the file is a whole picture with that content key.
bool is_finished_picture(const std::filesystem::path& file, const std::string& content);

// Whether the file is a whole part, of that shard, of the picture with that key.
bool is_finished_part(const std::filesystem::path& file, const PictureKey& key, const Shard& shard,
                      const Development& development);

}  // namespace penumbra
