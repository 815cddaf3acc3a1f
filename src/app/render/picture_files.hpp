// The files of a picture: what determines them, whether an earlier run has finished them, and their bytes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/render/picture_job.hpp"

namespace penumbra {

// The key of a picture's metadata that holds its content_key().
inline constexpr const char* content_entry = "content";

// A hash, as text, of everything that determines the file of a picture: version, files of the scene, options.
std::string content_key(const PictureKey& key, const Development& development);

// Whether the file is the complete picture, or the complete part, that the job makes.
bool is_finished_file(const std::filesystem::path& file, const PictureJob& job, bool is_part);

// Encodes the job's files one after the other, in their order, and hands each to `write(path, bytes)`. An unfinished
// picture is encoded as it stands, an unfinished part not at all. Consumes the film.
void encode_files(const PictureJob& job, Film film, bool finished, bool is_part,
                  const std::vector<std::filesystem::path>& files,
                  const std::function<void(const std::filesystem::path&, std::span<const std::byte>)>& write);

}  // namespace penumbra
