// Finds, before rendering starts, what would make the work useless.
#pragma once

#include <filesystem>
#include <vector>

#include "app/options/render_options.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

// Reports what is wrong and returns its exit code; 0 if nothing is. `files` are the output files of each picture.
int check_before_rendering(const RenderOptions& options, const std::vector<Action>& actions,
                           const std::vector<std::vector<std::filesystem::path>>& files);

}  // namespace penumbra
