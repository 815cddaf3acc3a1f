#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "viewer/window/boxes.hpp"
#include "viewer/window/drawing.hpp"

namespace penumbra {
namespace {

void draw_status(const Session& session, int height) {
  const float width = static_cast<float>(session.view().area().width);
  const float bar = scaled(status_height), top = static_cast<float>(height) - bar, inset = scaled(14);
  ImFont* const letters = font(Font::text);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({0, top}, {width, top + bar}, colors::panel);
  const auto width_of = [letters](const std::string& text) {
    return letters->CalcTextSizeA(letters->FontSize, FLT_MAX, 0, text.c_str()).x;
  };
  const auto add = [&](const std::string& text, float x) {
    list.AddText(letters, letters->FontSize, {std::floor(x), std::floor(top + (bar - letters->FontSize) / 2)},
                 colors::quiet, text.c_str());
  };
  const std::string text = status_line(session), hint = "H  help";
  add(text, inset);
  const float hint_at = width - inset - width_of(hint);
  if (inset + width_of(text) + inset < hint_at) add(hint, hint_at);
}

// Over the picture, or over the whole window where that is too narrow.
WindowArea draw_help(const Session& session, const Drawn& drawn) {
  const WindowArea& area = session.view().area();
  const WindowArea bounds =
      static_cast<float>(area.width) > scaled(800) ? area : WindowArea{0, 0, drawn.width, drawn.height};
  std::vector<BoxLine> lines;
  for (const KeyHelp& line : key_help) lines.push_back({line.keys, line.meaning});
  return draw_box(lines, {Font::text, colors::panel, colors::line}, bounds, {0.5f, 0.5f});
}

std::string error_text(const std::optional<double>& error) { return error ? fmt::format("{:.4f}", *error) : "-"; }

}  // namespace

std::string status_line(const Session& session) {
  std::string text = session.path().filename().string();
  const auto& picture = session.picture();
  if (!picture || !session.picture_is_current()) return text + (session.error().empty() ? "   ..." : "   has an error");
  text += fmt::format("   {} rays per pixel", picture->rays);
  if (session.limit() > 0) text += fmt::format(" of {}", session.limit());
  if (session.paused()) text += " (paused)";
  if (picture->done) text += " (done)";
  text +=
      fmt::format("   {:.1f} Mrays/s   {:.1f} s",
                  1e-6 * static_cast<double>(picture->rays_sent) / std::max(picture->seconds, 1e-9), picture->seconds);
  for (std::size_t i = 0; i < picture->sides.size(); i++) {
    const RefinedSide& side = picture->sides[i];
    text += fmt::format("   {}{}, error {}", i > 0 ? "| " : "",
                        pattern_names[static_cast<int>(side.frame->settings.pattern)], error_text(side.error));
    if (!side.options.without.empty()) text += ", without " + to_string(side.options.without);
  }
  if (session.exposure_halves() != 0) text += fmt::format("   exposure {:+.1f}", session.exposure_halves() / 2.0);
  return text;
}

void draw_overlays(const Session& session, Drawn& drawn) {
  draw_status(session, drawn.height);
  const WindowArea& area = session.view().area();
  constexpr BoxStyle error_style{Font::mono, colors::error_box, colors::error_line};
  if (!session.error().empty()) drawn.error = draw_box(lines_of(session.error()), error_style, area, {0, 0});
  if (session.moves_camera()) {
    draw_box(lines_of("Camera: drag turns, Shift and drag moves, the wheel brings nearer"), {}, area, {0.5f, 0});
  }
  if (!session.message().empty()) draw_box(lines_of(session.message()), {}, area, {0.5f, 1});
  if (session.help()) drawn.help = draw_help(session, drawn);
}

}  // namespace penumbra
