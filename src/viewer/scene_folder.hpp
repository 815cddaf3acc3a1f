// Which scenes a window shows: the given file, or those of a folder, by the keys 1-9 and Shift+1-9 or one after the
// other.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra {

// s0Na.cli of the folder, or s0Nb.cli for the twin; 1 <= number <= 9.
std::filesystem::path scene_of_key(const std::filesystem::path& folder, int number, bool twin);

// All .cli files of the folder, by name.
std::vector<std::filesystem::path> scenes_of(const std::filesystem::path& folder);

// The scene `step` places after `now` in this list, which goes round; the first one if `now` is not in it. Empty if
// there is none.
std::filesystem::path scene_after(const std::vector<std::filesystem::path>& scenes, const std::filesystem::path& now,
                                  int step);

// The scene to begin with: `given` itself; if that is a folder, the first of its s01a.cli, s01b.cli, ..., or else its
// first .cli file by name. Empty if it has none.
std::filesystem::path first_scene(const std::filesystem::path& given);

// The folder whose scenes the keys load.
std::filesystem::path folder_of(const std::filesystem::path& given);

}  // namespace penumbra
