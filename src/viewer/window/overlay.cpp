#include <fmt/format.h>

#include "viewer/window/drawing.hpp"

namespace penumbra {
namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs;

void draw_status(const Session& session, int width, int height) {
  ImGui::SetNextWindowPos(place(0, height - status_height));
  ImGui::SetNextWindowSize(place(width, status_height));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, place(1, 1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, place(8, 5));
  if (ImGui::Begin("status", nullptr, fixed)) ImGui::TextUnformatted(status_line(session).c_str());
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void draw_help(const Session& session) {
  const WindowArea area = session.view().area();
  ImGui::SetNextWindowPos(place(area.x + area.width / 2.0, area.y + area.height / 2.0), 0, place(0.5, 0.5));
  ImGui::SetNextWindowBgAlpha(0.92f);
  if (ImGui::Begin("help", nullptr, fixed | ImGuiWindowFlags_AlwaysAutoResize)) {
    for (const KeyHelp& line : key_help) {
      ImGui::TextColored({1, 0.85f, 0.4f, 1}, "%-12s", line.keys);
      ImGui::SameLine();
      ImGui::TextUnformatted(line.meaning);
    }
  }
  ImGui::End();
}

void draw_error(const Session& session) {
  const WindowArea area = session.view().area();
  ImGui::SetNextWindowPos(place(area.x + 12, area.y + 12));
  ImGui::SetNextWindowSizeConstraints(place(0, 0), place(area.width - 24, area.height - 24));
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.35f, 0.05f, 0.05f, 1});
  if (ImGui::Begin("error", nullptr, fixed | ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::TextUnformatted(session.error().c_str());
  }
  ImGui::End();
  ImGui::PopStyleColor();
}

void draw_message(const Session& session) {
  const WindowArea area = session.view().area();
  ImGui::SetNextWindowPos(place(area.x + area.width / 2.0, area.y + area.height - 12), 0, place(0.5, 1));
  ImGui::SetNextWindowBgAlpha(0.85f);
  if (ImGui::Begin("message", nullptr, fixed | ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::TextUnformatted(session.message().c_str());
  }
  ImGui::End();
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

void draw_overlays(const Session& session, int window_width, int window_height) {
  draw_status(session, window_width, window_height);
  if (!session.error().empty()) draw_error(session);
  if (!session.message().empty()) draw_message(session);
  if (session.help()) draw_help(session);
}

}  // namespace penumbra
