// A scene file as the window wants it: its last picture, what is wrong with it, and the files it was read from.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "language/scene_file.hpp"
#include "viewer/file_stamp.hpp"

namespace penumbra {

struct LoadedScene {
  std::filesystem::path path;
  std::shared_ptr<const Scene> scene;  // of the last picture; null if there is any error
  std::vector<PaintedRect> rects;      // of the last picture
  std::vector<Diagnostic> diagnostics;
  std::vector<FileStamp> files;  // all that the scene consists of, as they were when it was read
};

// Never throws for what the files contain.
LoadedScene load_scene(const std::filesystem::path& path, const ReadOptions& options);

}  // namespace penumbra
