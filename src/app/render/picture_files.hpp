// The files of a picture: what they are made of, whether an earlier run has finished them, and writing them.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/render/picture_job.hpp"

namespace penumbra {

// The key of a picture's metadata that holds its content_key().
inline constexpr const char* content_entry = "content";

// A hash, as text, of all that the file of a picture is made of: the version, the files of the scene, the options.
std::string content_key(const PictureKey& key, const Development& development);

// Whether the file is the whole picture, or the whole part, that the job makes.
bool is_finished_file(const std::filesystem::path& file, const PictureJob& job, bool is_part);

// The bytes of the job's files in their order, encoded one after the other as `write(path, bytes)` wants them; of a
// picture that is not `finished` as it stands, of such a part none. The film is used up.
void encode_files(const PictureJob& job, Film film, bool finished, bool is_part,
                  const std::vector<std::filesystem::path>& files,
                  const std::function<void(const std::filesystem::path&, std::span<const std::byte>)>& write);

}  // namespace penumbra
