// Scenes whose eye is in the wrong place.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace penumbra {

// A sentence if no object can be in view at any time of the shutter: all are behind the eye, or outside the picture.
// Empty if one can, or if there is none. `moves`: whether something moves while the shutter is open.
std::string empty_view_warning(const Scene& scene, bool moves);

// A sentence if the eye is inside an opaque solid when the shutter opens, unless that holds other objects, as a room or
// a sky does. Meshes and polygons count as no solids. Empty if it is not.
std::string buried_eye_warning(const Scene& scene);

}  // namespace penumbra
