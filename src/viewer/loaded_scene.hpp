// Which scenes a window shows: the given file, or those of a folder, by the keys 1-9 and Shift+1-9; and such a scene:
// its last picture, its errors and warnings, and the files it was read from.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "language/scene_file.hpp"
#include "picture/picture_options.hpp"
#include "viewer/file_stamp.hpp"

namespace penumbra {

// s0Na.cli of the folder, or s0Nb.cli for the twin; 1 <= number <= 9.
std::filesystem::path scene_of_key(const std::filesystem::path& folder, int number, bool twin);

// The scene to begin with: `given` itself; if that is a folder, the first of its s01a.cli, s01b.cli, ..., or else its
// first .cli file by name. Empty if it has none.
std::filesystem::path first_scene(const std::filesystem::path& given);

// The folder whose scenes the keys load.
std::filesystem::path folder_of(const std::filesystem::path& given);

struct LoadedScene {
  std::filesystem::path path;
  std::shared_ptr<const Scene> scene;  // of the last picture; null if there is any error
  std::vector<PaintedRect> rects;      // of the last picture
  std::vector<Diagnostic> diagnostics;
  std::vector<FileStamp> files;  // all files of the scene, as they were when it was read
};

// With the warnings that `check` gives, of the pictures as they are with the options. Never throws because of the
// contents of the files.
LoadedScene load_scene(const std::filesystem::path& path, const PictureOptions& options);

}  // namespace penumbra
