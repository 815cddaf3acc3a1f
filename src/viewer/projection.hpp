// Projects points of the world into the picture.
#pragma once

#include <optional>
#include <utility>

#include "tracing/frame.hpp"

namespace penumbra {

struct PlaceInPicture {
  double x = 0, y = 0;  // pixels from the top left
};

// The ends of the part of a line that lies in front of the eye, as a pinhole sees them; nothing if all of it is behind.
std::optional<std::pair<PlaceInPicture, PlaceInPicture>> project_line(const FrameCamera& camera, const float (&from)[3],
                                                                      const float (&to)[3]);

}  // namespace penumbra
