// What would make the work of rendering useless, found before it starts.
#pragma once

#include <filesystem>
#include <vector>

#include "app/options/render_options.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

// Tells what is wrong and returns the exit code for it; 0 if nothing is. `files` are those of each picture.
int check_before_rendering(const RenderOptions& options, const std::vector<Action>& actions,
                           const std::vector<std::vector<std::filesystem::path>>& files);

}  // namespace penumbra
