// What single precision, in which rays are computed, cannot hold.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace penumbra {

// A sentence about an object so small for its distance from the origin that the steps between numbers of single
// precision show on it, with advice, and about how many there are; empty if there is none.
std::string precision_warning(const Scene& scene);

}  // namespace penumbra
