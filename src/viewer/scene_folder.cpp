#include "viewer/scene_folder.hpp"

#include <algorithm>
#include <string>
#include <system_error>

namespace penumbra {

std::filesystem::path scene_of_key(const std::filesystem::path& folder, int number, bool twin) {
  return folder / ("s0" + std::string(1, static_cast<char>('0' + number)) + (twin ? "b.cli" : "a.cli"));
}

std::vector<std::filesystem::path> scenes_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> scenes;
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(folder.empty() ? "." : folder, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path name = entry->path().filename();
    std::error_code unknown;
    if (name.extension() == ".cli" && !entry->is_directory(unknown)) scenes.push_back(folder / name);
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

std::filesystem::path scene_after(const std::vector<std::filesystem::path>& scenes, const std::filesystem::path& now,
                                  int step) {
  if (scenes.empty()) return {};
  const auto found = std::find(scenes.begin(), scenes.end(), now);
  if (found == scenes.end()) return scenes.front();
  const auto count = static_cast<std::ptrdiff_t>(scenes.size());
  return scenes[static_cast<std::size_t>(((found - scenes.begin() + step) % count + count) % count)];
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
  const std::vector<std::filesystem::path> scenes = scenes_of(given);
  return scenes.empty() ? std::filesystem::path() : scenes.front();
}

std::filesystem::path folder_of(const std::filesystem::path& given) {
  std::error_code ignored;
  return std::filesystem::is_directory(given, ignored) ? given : given.parent_path();
}

}  // namespace penumbra
