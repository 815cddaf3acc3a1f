// The knobs of the panel: each in a row, with what it changes to its left.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture/option_table.hpp"
#include "viewer/window/drawing.hpp"

namespace penumbra {

// Records where the last widget is.
void add_place(std::vector<KnobPlace>& places, const std::string& label);

// Begins a row with this text; the widget that follows fills the rest.
void label(const std::string& text);

// Within an open combo box: closes it when the user presses Escape.
void close_with_escape();

struct TurnedKnob {
  Knob knob;
  double value = 0;
};

// Draws these knobs of a scene. Returns the one that the user has just changed. `side`: a number that ends the labels
// in `places`; -1: none.
std::optional<TurnedKnob> draw_knobs(std::vector<KnobPlace>& places, const Session& session, const Scene& scene,
                                     const std::vector<Knob>& knobs, int side);

}  // namespace penumbra
