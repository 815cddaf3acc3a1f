#include "viewer/window/theme.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

extern "C" {
extern const unsigned char penumbra_text_font[], penumbra_text_font_end[];
extern const unsigned char penumbra_heading_font[], penumbra_heading_font_end[];
extern const unsigned char penumbra_mono_font[], penumbra_mono_font_end[];
}

namespace penumbra {
namespace {

constexpr float text_height = 17;  // from the top of the tallest letter to the bottom of the lowest
constexpr float mono_height = 15;

double scale_now = 1;

void add_font(const unsigned char* first, const unsigned char* last, float height) {
  // Latin, Greek and Cyrillic letters of file names, and punctuation.
  static constexpr ImWchar ranges[] = {0x20, 0x24f, 0x370, 0x52f, 0x2010, 0x2026, 0};
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 2;
  config.OversampleV = 1;
  ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<unsigned char*>(first), static_cast<int>(last - first),
                                             std::round(scaled(height)), &config, ranges);
}

ImVec4 as_vector(ImU32 color) { return ImGui::ColorConvertU32ToFloat4(color); }

void set_colors() {
  ImVec4* color = ImGui::GetStyle().Colors;
  const auto grey = [](int value, int alpha = 255) { return as_vector(IM_COL32(value, value, value, alpha)); };
  color[ImGuiCol_Text] = as_vector(colors::text);
  color[ImGuiCol_TextDisabled] = as_vector(colors::quiet);
  color[ImGuiCol_WindowBg] = as_vector(colors::panel);
  color[ImGuiCol_PopupBg] = grey(38);
  color[ImGuiCol_Border] = grey(58);
  color[ImGuiCol_FrameBg] = grey(44);
  color[ImGuiCol_FrameBgHovered] = grey(54);
  color[ImGuiCol_FrameBgActive] = grey(64);
  color[ImGuiCol_Button] = grey(48);
  color[ImGuiCol_ButtonHovered] = grey(60);
  color[ImGuiCol_ButtonActive] = grey(72);
  color[ImGuiCol_Header] = grey(58);
  color[ImGuiCol_HeaderHovered] = grey(68);
  color[ImGuiCol_HeaderActive] = grey(78);
  color[ImGuiCol_Separator] = grey(52);
  color[ImGuiCol_ScrollbarBg] = grey(0, 0);
  color[ImGuiCol_ScrollbarGrab] = grey(66);
  color[ImGuiCol_ScrollbarGrabHovered] = grey(84);
  color[ImGuiCol_ScrollbarGrabActive] = grey(100);
  color[ImGuiCol_CheckMark] = as_vector(colors::accent);
  color[ImGuiCol_SliderGrab] = grey(120);
  color[ImGuiCol_SliderGrabActive] = as_vector(colors::accent);
  color[ImGuiCol_TextSelectedBg] = as_vector(IM_COL32(240, 190, 90, 90));
}

void set_shapes() {
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = place(14, 12);
  style.FramePadding = place(8, 3);
  style.ItemSpacing = place(8, 6);
  style.ItemInnerSpacing = place(7, 4);
  style.WindowBorderSize = style.FrameBorderSize = style.PopupBorderSize = 0;
  style.WindowRounding = 0;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
  style.ScrollbarSize = 10;
  style.ScrollbarRounding = 5;
  style.ScaleAllSizes(static_cast<float>(scale_now));
}

}  // namespace

void set_theme(double scale) {
  scale_now = scale;
  add_font(penumbra_text_font, penumbra_text_font_end, text_height);
  add_font(penumbra_heading_font, penumbra_heading_font_end, text_height);
  add_font(penumbra_mono_font, penumbra_mono_font_end, mono_height);
  ImGui::StyleColorsDark();
  set_colors();
  set_shapes();
}

ImFont* font(Font which) { return ImGui::GetIO().Fonts->Fonts[static_cast<int>(which)]; }

std::string wrapped(Font which, std::string_view text, float width) {
  ImFont* const letters = font(which);
  const auto width_of = [letters](std::string_view part) {
    return letters->CalcTextSizeA(letters->FontSize, FLT_MAX, 0, part.data(), part.data() + part.size()).x;
  };
  std::string result;
  std::size_t begin = 0, last_blank = text.npos;
  for (std::size_t i = 0; i <= text.size(); i++) {
    const bool ends = i == text.size() || text[i] == '\n';
    if (!ends && text[i] != ' ') continue;
    if (last_blank != text.npos && width_of(text.substr(begin, i - begin)) > width) {
      result.append(text.substr(begin, last_blank - begin)) += '\n';
      begin = last_blank + 1;
    }
    last_blank = i > begin ? i : text.npos;
    if (!ends) continue;
    result.append(text.substr(begin, i - begin));
    if (i < text.size()) result += '\n';
    begin = i + 1;
    last_blank = text.npos;
  }
  return result;
}

float scaled(double length) { return static_cast<float>(length * scale_now); }

ImU32 color_of(Vec3 color) {
  const auto byte = [](double value) { return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0))); };
  return IM_COL32(byte(color.x), byte(color.y), byte(color.z), 255);
}

}  // namespace penumbra
