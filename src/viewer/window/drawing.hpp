// What is drawn over and beside the picture: texts (overlay.cpp), the pixel inspector (inspector.cpp) and the knobs of
// the scene (panel.cpp).
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "viewer/session.hpp"

namespace penumbra {

// A place in the window, in pixels, as Dear ImGui takes it.
inline ImVec2 place(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

// Help, errors and messages over the picture, and the status line below it.
inline constexpr int status_height = 26;  // pixels

void draw_overlays(const Session& session, int window_width, int window_height);

// Scene, rays per pixel, rays per second, time, sampler, estimated error.
std::string status_line(const Session& session);

// The rays of an inspected sample as lines over the picture and as text, and where the samples lie. Returns the area of
// its text and plots, if they are shown.
std::optional<WindowArea> draw_inspector(const Session& session);

// The knobs, to the right of the picture. Every change redraws the picture at once.
inline constexpr int panel_width = 280;  // pixels

// Where a knob is: the middle of what can be dragged or clicked.
struct KnobPlace {
  std::string label;
  int x = 0, y = 0;
};

// Returns the places of all knobs.
std::vector<KnobPlace> draw_panel(Session& session, int window_width, int window_height);

}  // namespace penumbra
