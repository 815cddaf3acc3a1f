// The files that each picture of a scene file is written to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/options/command_line.hpp"
#include "language/scene_file.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {

// Stores the value of -o, where `-` is standard output.
TakeText into_outputs(std::vector<std::string>& outputs);

// Whether a picture goes to standard output, which then gets nothing else.
bool has_standard_output(const std::vector<std::string>& outputs);

// The files to write for each picture among the actions, in their order. With `outputs`, every picture goes to each of
// these, picture k of several as OUT-k.ext; without, `write` goes to the file it names and `render` to SCENE.png, then
// SCENE-2.png and so on, in the working directory. Pictures and frames follow one another on standard output.
std::vector<std::vector<std::filesystem::path>> output_files(const std::vector<Action>& actions,
                                                             const std::filesystem::path& scene,
                                                             const std::vector<std::string>& outputs);

// The file with the number of the frame in place of `####` (as many digits as there are #) or `%04d` in its name; none
// if the name has neither.
std::optional<std::filesystem::path> with_frame_in_pattern(const std::filesystem::path& file, int frame);

// The same; OUT.0007.ext for OUT.ext.
std::filesystem::path with_frame_number(const std::filesystem::path& file, const AnimationFrame& frame);

// The number of digits of frame numbers: as many as the last frame of the animation has, but at least four.
int frame_digits(int last_frame);

}  // namespace penumbra
