#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture/option_table.hpp"
#include "viewer/window/drawing.hpp"

namespace penumbra {
namespace {

using Places = std::vector<KnobPlace>;

// Records where the last widget is.
void add_place(Places& places, const std::string& label) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  // The rectangle may include a label on the right.
  places.push_back(
      {label, static_cast<int>(low.x + std::min(high.x - low.x, 20.0f) / 2), static_cast<int>((low.y + high.y) / 2)});
}

void draw_rays(Places& places, Session& session) {
  int limit = static_cast<int>(session.limit());
  ImGui::SetNextItemWidth(110);
  if (ImGui::InputInt("rays per pixel", &limit, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue)) {
    session.set_limit(static_cast<std::uint32_t>(std::clamp(limit, 0, most_rays_per_pixel)));
  }
  add_place(places, "rays per pixel");
  ImGui::TextDisabled(session.limit() == 0 ? "0: as long as you look" : "the scene says %d",
                      session.scene()->settings.rays_per_pixel);
}

// Draws a choice of several names. True if another one was chosen.
bool choose(const Knob& knob, double& value) {
  const std::size_t now = static_cast<std::size_t>(value);
  bool changed = false;
  const bool open = ImGui::BeginCombo(knob.label.c_str(), knob.choices[now].data());
  if (!open) return false;
  for (std::size_t i = 0; i < knob.choices.size(); i++) {
    if (!ImGui::Selectable(knob.choices[i].data(), i == now)) continue;
    value = static_cast<double>(i);
    changed = true;
  }
  ImGui::EndCombo();
  return changed;
}

// Draws a knob. True if the user changed its value.
bool turn(const Knob& knob, double& value) {
  switch (knob.kind) {
    case Knob::Kind::real: {  // dragged in steps proportional to its value
      const auto speed = static_cast<float>(std::max(std::abs(value) * 0.01, 0.002));
      return ImGui::DragScalar(knob.label.c_str(), ImGuiDataType_Double, &value, speed, &knob.low, &knob.high, "%.4g",
                               ImGuiSliderFlags_AlwaysClamp);
    }
    case Knob::Kind::whole: {
      auto number = static_cast<std::uint32_t>(value);
      const std::uint32_t one = 1;
      const bool changed = ImGui::InputScalar(knob.label.c_str(), ImGuiDataType_U32, &number, &one);
      value = std::clamp(static_cast<double>(number), knob.low, knob.high);
      return changed;
    }
    case Knob::Kind::slider: {
      int number = static_cast<int>(value);
      const bool changed = ImGui::SliderInt(knob.label.c_str(), &number, static_cast<int>(knob.low),
                                            static_cast<int>(knob.high), "%d", ImGuiSliderFlags_AlwaysClamp);
      value = number;
      return changed;
    }
    case Knob::Kind::choice:
      return choose(knob, value);
    case Knob::Kind::toggle: {
      bool on = value != 0;
      const bool changed = ImGui::Checkbox(knob.label.c_str(), &on);
      value = on ? 1 : 0;
      return changed;
    }
  }
  return false;
}

// The knobs of all options that both sides share, or of those that each side has separately.
void draw_options(Places& places, Session& session, bool each_side, int side) {
  const Scene scene = each_side ? session.changed_scene(side) : session.scene_with_all_effects();
  for (const PictureOption& row : option_table()) {
    if (!row.knobs || row.each_side != each_side) continue;
    for (const Knob& knob : row.knobs(scene, session.options(side))) {
      double value = knob.value;
      const bool changed = turn(knob, value);
      add_place(places, each_side ? fmt::format("{} {}", knob.label, side) : knob.label);
      if (!changed) continue;
      const auto set = [&](PictureOptions& options) { knob.set(options, value); };
      if (each_side) {
        session.change_side(side, set);
      } else {
        session.change(set);
      }
    }
  }
}

Places draw_knobs(Session& session) {
  Places places;
  draw_rays(places, session);
  ImGui::Separator();
  draw_options(places, session, false, 0);
  ImGui::Separator();
  for (int side = 0; side < session.side_count(); side++) {
    if (session.split()) ImGui::TextDisabled(side == 0 ? "left" : "right");
    ImGui::PushID(side);
    draw_options(places, session, true, side);
    ImGui::PopID();
  }
  ImGui::Separator();
  if (ImGui::Button("As in the file")) session.forget_changes();
  add_place(places, "As in the file");
  ImGui::SameLine();
  ImGui::TextDisabled("H: keys");
  return places;
}

}  // namespace

std::vector<KnobPlace> draw_panel(Session& session, int window_width, int window_height) {
  ImGui::SetNextWindowPos(place(window_width - panel_width, 0));
  ImGui::SetNextWindowSize(place(panel_width, window_height - status_height));
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoNav;
  Places places;
  if (ImGui::Begin("panel", nullptr, flags)) {
    ImGui::PushItemWidth(110);
    if (session.scene()) places = draw_knobs(session);
    ImGui::PopItemWidth();
  }
  ImGui::End();
  return places;
}

}  // namespace penumbra
