// The distance of what a pixel shows: where to put the plane in focus.
#pragma once

#include <optional>

#include "tracing/frame.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

// The distance, along -w, of the first hit of the ray from the eye through the point (x, y) of the picture, in pixels,
// at the time when the shutter opens; nothing if it hits nothing.
std::optional<double> distance_at(const Frame& frame, const Kernel& kernel, double x, double y);

}  // namespace penumbra
