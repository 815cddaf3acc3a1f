#include "viewer/loaded_scene.hpp"

#include <fmt/format.h>

#include <utility>

#include "picture/examine.hpp"

namespace penumbra {

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
  loaded.lights = std::move(file.lights);
  loaded.surfaces = std::move(file.surfaces);
  for (Action& action : file.actions) {
    auto* picture = std::get_if<Picture>(&action);
    if (!picture) continue;
    loaded.scene = std::move(picture->scene);
    loaded.rects = std::move(picture->rects);
  }
  return loaded;
}

std::string name_of(const CommandPlace& place) {
  const std::string file = place.file.empty() ? std::string() : place.file + ' ';
  return fmt::format("{}line {}, {}", file, place.line, place.command);
}

}  // namespace penumbra
