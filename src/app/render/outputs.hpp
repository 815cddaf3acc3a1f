// Which picture of a scene file goes to which files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "language/scene_file.hpp"
#include "picture/animation.hpp"

namespace penumbra {

// For each picture among the actions, in their order, the files to write. With `outputs`, every picture goes to each of
// them, picture k of several under OUT-k.ext; without, `write` goes to the file it names and `render` to SCENE.png,
// then SCENE-2.png and so on, in the working directory.
std::vector<std::vector<std::filesystem::path>> output_files(const std::vector<Action>& actions,
                                                             const std::filesystem::path& scene,
                                                             const std::vector<std::string>& outputs);

// OUT.0007.ext for OUT.ext.
std::filesystem::path with_frame_number(const std::filesystem::path& file, const AnimationFrame& frame);

// How many digits the numbers of frames have: as many as the last one of the animation, and four at least.
int frame_digits(int last_frame);

}  // namespace penumbra
