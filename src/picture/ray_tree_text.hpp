// The rays of one sample in words.
#pragma once

#include <string>

#include "rendering/ray_tree.hpp"

namespace penumbra {

// One line for each ray, deeper ones indented, every number to the last digit; then the sum.
std::string ray_tree_text(const Frame& frame, const RayTree& tree, int x, int y, std::uint32_t sample);

}  // namespace penumbra
