// Saves what the window shows, so that `penumbra render` can repeat it byte for byte from the file's own metadata.
#pragma once

#include <filesystem>
#include <vector>

#include "viewer/refiner.hpp"

namespace penumbra {

// Writes each side to a PNG in `folder`: SCENE-view.png, or SCENE-view-left.png and SCENE-view-right.png, with -2, -3
// and so on if these files exist already. Returns their paths. Throws FileError.
std::vector<std::filesystem::path> save_picture(const Refinement& picture, int exposure_halves,
                                                const std::filesystem::path& folder);

}  // namespace penumbra
