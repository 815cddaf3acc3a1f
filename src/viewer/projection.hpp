// From the world to the picture and back: where points are seen, and how far away a pixel is.
#pragma once

#include <optional>
#include <utility>

#include "base/vec.hpp"
#include "tracing/frame.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

struct PlaceInPicture {
  double x = 0, y = 0;  // pixels from the top left
};

// The ends of the part of a line that lies in front of the eye, as a pinhole sees them; nothing if all of it is behind.
std::optional<std::pair<PlaceInPicture, PlaceInPicture>> project_line(const FrameCamera& camera, const float (&from)[3],
                                                                      const float (&to)[3]);

// Where the ray from the eye through the point (x, y) of the picture, in pixels, first hits something at the time when
// the shutter opens, in the world of the scene; nothing if it hits nothing.
std::optional<Vec3> point_at(const Frame& frame, const Kernel& kernel, double x, double y);

// The distance, along -w, of that point; nothing if there is none in front of the eye.
std::optional<double> distance_at(const Frame& frame, const Kernel& kernel, double x, double y);

}  // namespace penumbra
