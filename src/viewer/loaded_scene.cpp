#include "viewer/loaded_scene.hpp"

#include <utility>

namespace penumbra {

LoadedScene load_scene(const std::filesystem::path& path, const ReadOptions& options) {
  const StampClock before = StampClock::now();
  LoadedScene loaded;
  loaded.path = path;
  ReadOptions careful = options;
  careful.edited = true;
  SceneFile file = read_scene(path, careful);
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
