#include "viewer/loaded_scene.hpp"

#include <utility>

#include "picture/examine.hpp"

namespace penumbra {

std::filesystem::path scene_of_key(const std::filesystem::path& folder, int number, bool twin) {
  return folder / ("s0" + std::string(1, static_cast<char>('0' + number)) + (twin ? "b.cli" : "a.cli"));
}

std::filesystem::path folder_of(const std::filesystem::path& given) {
  std::error_code ignored;
  return std::filesystem::is_directory(given, ignored) ? given : given.parent_path();
}

std::filesystem::path first_scene(const std::filesystem::path& given) {
  std::error_code error;
  if (!std::filesystem::is_directory(given, error)) return given;
  for (int number = 1; number <= 9; number++) {
    for (const bool twin : {false, true}) {
      std::filesystem::path path = scene_of_key(given, number, twin);
      if (std::filesystem::exists(path, error)) return path;
    }
  }
  std::filesystem::path first;
  for (auto entry = std::filesystem::directory_iterator(given, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& path = entry->path();
    if (path.extension() == ".cli" && (first.empty() || path.filename() < first.filename())) first = path;
  }
  return first;
}

LoadedScene load_scene(const std::filesystem::path& path, const PictureOptions& options) {
  const StampClock before = StampClock::now();
  LoadedScene loaded;
  loaded.path = path;
  SceneFile file = read_and_examine(path, options, {.edited = true});
  loaded.files.push_back(stamp_of(path, before));
  for (const std::string& name : file.files) {
    if (name != path.string()) loaded.files.push_back(stamp_of(name, before));
  }
  loaded.diagnostics = std::move(file.diagnostics);
  for (Action& action : file.actions) {
    auto* picture = std::get_if<Picture>(&action);
    if (!picture) continue;
    loaded.scene = std::move(picture->scene);
    loaded.rects = std::move(picture->rects);
  }
  return loaded;
}

}  // namespace penumbra
