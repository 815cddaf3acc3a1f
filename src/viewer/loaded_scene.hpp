// A scene as the window shows it: its last picture, its errors and warnings, and the files it was read from.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "language/scene_file.hpp"
#include "picture/picture_options.hpp"
#include "viewer/file_stamp.hpp"

namespace penumbra {

struct LoadedScene {
  std::filesystem::path path;
  std::shared_ptr<const Scene> scene;          // of the last picture; null if there is any error
  std::vector<CommandPlace> lights, surfaces;  // of that scene
  std::vector<PaintedRect> rects;              // of the last picture
  std::vector<Diagnostic> diagnostics;
  std::vector<FileStamp> files;  // all files of the scene, as they were when it was read
};

// With the warnings that `check` gives, of the pictures as they are with the options. Never throws because of the
// contents of the files.
LoadedScene load_scene(const std::filesystem::path& path, const PictureOptions& options);

// What people call a light or a surface: "line 23, glossy", "parts/lamp.cli line 4, disk_light".
std::string name_of(const CommandPlace& place);

}  // namespace penumbra
