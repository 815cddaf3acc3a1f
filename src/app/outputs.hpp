// Which picture of a scene file goes to which files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "language/scene_file.hpp"

namespace penumbra {

// For each picture among the actions, in their order, the files to write. With `outputs`, every picture goes to each of
// them, picture k of several under OUT-k.ext; without, `write` goes to the file it names and `render` to SCENE.png,
// then SCENE-2.png and so on, in the working directory.
std::vector<std::vector<std::filesystem::path>> output_files(const std::vector<Action>& actions,
                                                             const std::filesystem::path& scene,
                                                             const std::vector<std::string>& outputs);

}  // namespace penumbra
