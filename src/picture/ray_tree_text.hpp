// The rays of one sample as text.
#pragma once

#include <string>

#include "rendering/ray_tree.hpp"

namespace penumbra {

// One line per ray, indented by depth, with every number to its last digit; then the sum.
std::string ray_tree_text(const Frame& frame, const RayTree& tree, int x, int y, std::uint32_t sample);

}  // namespace penumbra
