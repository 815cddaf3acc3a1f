// Texts in boxes over the picture. A box is as large as its text at once: Dear ImGui's own windows need a second frame
// for that, and stay hidden in the first.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viewer/picture_view.hpp"
#include "viewer/window/theme.hpp"

namespace penumbra {

struct BoxStyle {
  Font font = Font::text;
  ImU32 fill = colors::box;
  ImU32 line = colors::line;
};

// A line of a box; with a key, that stands in a column of its own, to the left.
struct BoxLine {
  std::string_view key, text;
};

// Draws the box within `bounds`: in the middle, or against an edge, as `anchor` says with 0 to 1 in both directions.
// Long lines are wrapped; what does not fit below is left out, and the last line says so. Returns the place of the box.
WindowArea draw_box(const std::vector<BoxLine>& lines, const BoxStyle& style, const WindowArea& bounds, ImVec2 anchor);

// The lines of a text.
std::vector<BoxLine> lines_of(std::string_view text);

}  // namespace penumbra
