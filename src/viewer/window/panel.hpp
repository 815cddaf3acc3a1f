// The knobs of the scene, at the right of the picture. Every change draws the picture anew, at once.
#pragma once

#include "viewer/session.hpp"

namespace penumbra {

inline constexpr int panel_width = 280;  // pixels

void draw_panel(Session& session, int window_width, int window_height);

}  // namespace penumbra
