// How the window looks: fonts, sizes, colours. Greys are neutral, so that they leave the colours of the picture alone.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/vec.hpp"

namespace penumbra {

enum class Font { text, heading, mono };

// Loads the fonts and sets the style; `scale` is the size of everything relative to a screen of 96 dots per inch. Needs
// Dear ImGui's context.
void set_theme(double scale);

ImFont* font(Font which);

// The text with line ends in place of blanks, where its lines would be wider than this. (Dear ImGui would also end
// lines within numbers.)
std::string wrapped(Font which, std::string_view text, float width);

// A length on a screen of 96 dots per inch, in pixels.
float scaled(double length);

// A place in the window, in pixels, as Dear ImGui takes it.
inline ImVec2 place(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

namespace colors {
inline constexpr ImU32 background = IM_COL32(22, 22, 22, 255);
inline constexpr ImU32 panel = IM_COL32(30, 30, 30, 255);
inline constexpr ImU32 line = IM_COL32(58, 58, 58, 255);
inline constexpr ImU32 text = IM_COL32(222, 222, 222, 255);
inline constexpr ImU32 quiet = IM_COL32(142, 142, 142, 255);
inline constexpr ImU32 accent = IM_COL32(240, 190, 90, 255);
inline constexpr ImU32 box = IM_COL32(26, 26, 26, 240);
inline constexpr ImU32 error_box = IM_COL32(74, 22, 22, 246);
inline constexpr ImU32 error_line = IM_COL32(160, 60, 56, 255);
}  // namespace colors

// A colour of the scene, clamped, or of three bytes.
ImU32 color_of(Vec3 color);
inline ImU32 color_of(const std::array<std::uint8_t, 3>& rgb) { return IM_COL32(rgb[0], rgb[1], rgb[2], 255); }

}  // namespace penumbra
