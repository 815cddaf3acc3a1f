// What was changed in the window, in the words of the scene language.
#pragma once

#include <string>

#include "picture/picture_options.hpp"

namespace penumbra {

// One line for each command whose numbers `options` change: those of the camera and of the whole picture replace or
// follow the scene's, those of lights and surfaces replace the line that made them. What the language has no command
// for is a comment. Empty if nothing is changed.
std::string changed_lines(const Scene& scene, const PictureOptions& options);

}  // namespace penumbra
