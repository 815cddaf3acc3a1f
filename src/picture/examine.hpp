// Reads a scene and looks for what is allowed but probably not intended, beyond what its text shows.
#pragma once

#include <filesystem>

#include "language/scene_file.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {

// Reads a scene file, and adds the warnings about its pictures, as they are with the options, to those about how it is
// written. `read` has what the options do not say: all but course, lenient and allow_paths.
SceneFile read_and_examine(const std::filesystem::path& scene, const PictureOptions& options,
                           const ReadOptions& read = {});

}  // namespace penumbra
