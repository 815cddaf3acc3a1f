// The knobs of the scene, to the right of the picture. Every change redraws the picture at once.
#pragma once

#include <string>
#include <vector>

#include "viewer/session.hpp"

namespace penumbra {

inline constexpr int panel_width = 280;  // pixels

// Where a knob is: the middle of what can be dragged or clicked.
struct KnobPlace {
  std::string label;
  int x = 0, y = 0;
};

// Returns the places of all knobs.
std::vector<KnobPlace> draw_panel(Session& session, int window_width, int window_height);

}  // namespace penumbra
