// The pixel inspector: the rays of one sample as lines over the picture and as text, and where the samples lie.
#pragma once

#include <optional>

#include "viewer/session.hpp"

namespace penumbra {

// Returns the area of its text and plots, if they are shown.
std::optional<WindowArea> draw_inspector(const Session& session);

}  // namespace penumbra
