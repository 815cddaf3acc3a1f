// What is drawn over and beside the picture: texts (overlay.cpp), the pixel inspector (inspector.cpp) and the knobs of
// the scene (panel.cpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viewer/session.hpp"
#include "viewer/window/theme.hpp"

namespace penumbra {

// On a screen of 96 dots per inch.
inline constexpr int panel_width = 300;
inline constexpr int status_height = 30;

// Where a knob is: the middle of what can be dragged or clicked.
struct KnobPlace {
  std::string label;
  int x = 0, y = 0;
};

// Where things were drawn in a frame.
struct Drawn {
  int width = 0, height = 0;  // of the window
  std::vector<KnobPlace> knobs;
  std::optional<WindowArea> inspector, error, help;
};

// Help, errors and messages over the picture, and the status line below it.
void draw_overlays(const Session& session, Drawn& drawn);

// Scene, rays per pixel, rays per second, time, sampler, estimated error.
std::string status_line(const Session& session);

// The rays of an inspected sample as lines over the picture and as text, and where the samples lie.
void draw_inspector(const Session& session, Drawn& drawn);

// Copies the changed settings as lines of the scene, and says so.
void copy_changes(Session& session);

// The knobs, to the right of the picture. Every change redraws the picture at once.
void draw_panel(Session& session, Drawn& drawn);

}  // namespace penumbra
