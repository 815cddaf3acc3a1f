#include "viewer/window/knobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace penumbra {
namespace {

constexpr double label_width = 150, toggle_width = 132;

// Draws a choice of several names. True if another one was chosen.
bool choose(const Knob& knob, double& value) {
  const auto now = static_cast<std::size_t>(value);
  if (!ImGui::BeginCombo("##choice", knob.choices[now].data(), ImGuiComboFlags_HeightLarge)) return false;
  close_with_escape();
  bool changed = false;
  for (std::size_t i = 0; i < knob.choices.size(); i++) {
    if (!ImGui::Selectable(knob.choices[i].data(), i == now)) continue;
    value = static_cast<double>(i);
    changed = true;
  }
  ImGui::EndCombo();
  return changed;
}

// Draws the widget of a knob; `text` stands in it, before the number. True if the user changed its value.
bool turn(const Knob& knob, const std::string& text, double& value) {
  switch (knob.kind) {
    case Knob::Kind::real: {  // dragged in steps proportional to its value
      const auto speed = static_cast<float>(std::max(std::abs(value) * 0.01, 0.002));
      const std::string format = text.empty() ? "%.4g" : text + " %.4g";
      return ImGui::DragScalar("##real", ImGuiDataType_Double, &value, speed, &knob.low, &knob.high, format.c_str(),
                               ImGuiSliderFlags_AlwaysClamp);
    }
    case Knob::Kind::whole: {
      auto number = static_cast<std::uint32_t>(value);
      const std::uint32_t one = 1;
      const bool changed = ImGui::InputScalar("##whole", ImGuiDataType_U32, &number, &one);
      value = std::clamp(static_cast<double>(number), knob.low, knob.high);
      return changed;
    }
    case Knob::Kind::slider: {
      int number = static_cast<int>(value);
      const bool changed = ImGui::SliderInt("##slider", &number, static_cast<int>(knob.low),
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

void swatch(ImU32 color) {
  const float size = std::floor(ImGui::GetFontSize() * 0.75f);
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float top = std::floor(at.y + (ImGui::GetFrameHeight() - size) / 2 + scaled(1));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x, top}, {at.x + size, top + size}, color, scaled(3));
  list.AddRect({at.x, top}, {at.x + size, top + size}, colors::line, scaled(3));
  ImGui::Dummy({size, ImGui::GetFrameHeight()});
  ImGui::SameLine();
}

// What a knob of a light or a surface changes: its colour and its name.
struct Owner {
  CommandPlace place;
  std::string name;
  Vec3 color;
};

std::optional<Owner> owner_of(const Session& session, const Scene& scene, const Knob& knob) {
  if (knob.light > 0) {
    const Light& light = scene.lights[static_cast<std::size_t>(knob.light - 1)];
    return Owner{session.place_of_light(knob.light), session.name_of_light(knob.light),
                 std::visit([](const auto& l) { return l.color; }, light)};
  }
  if (knob.surface > 0) {
    return Owner{session.place_of_surface(knob.surface), session.name_of_surface(knob.surface),
                 scene.surfaces[static_cast<std::size_t>(knob.surface - 1)].diffuse};
  }
  return std::nullopt;
}

// Begins the row of a knob. `first`: of its owner. The name of another file stands above the owners in it.
void label_owner(Owner owner, bool first, std::string& file) {
  if (!first) return label("");
  if (std::exchange(file, owner.place.file) != owner.place.file) {
    ImGui::TextDisabled("%s", owner.place.file.empty() ? "in the scene itself" : owner.place.file.c_str());
  }
  owner.place.file.clear();
  swatch(color_of(owner.color));
  label(owner.place.line > 0 ? name_of(owner.place) : owner.name);
}

}  // namespace

void add_place(std::vector<KnobPlace>& places, const std::string& label) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  // The rectangle may include a label on the right.
  places.push_back(
      {label, static_cast<int>(low.x + std::min(high.x - low.x, 20.0f) / 2), static_cast<int>((low.y + high.y) / 2)});
}

void label(const std::string& text) {
  const float column = ImGui::GetStyle().WindowPadding.x + scaled(label_width);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  const bool fits = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x <= column;
  if (fits) ImGui::SameLine(column);
  if (!fits) ImGui::SetCursorPosX(column);
  ImGui::SetNextItemWidth(-1);
}

void close_with_escape() {
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
}

std::optional<TurnedKnob> draw_knobs(std::vector<KnobPlace>& places, const Session& session, const Scene& scene,
                                     const std::vector<Knob>& knobs, int side) {
  std::optional<TurnedKnob> turned;
  const Knob* before = nullptr;
  std::string file;
  for (std::size_t i = 0; i < knobs.size(); i++) {
    const Knob& knob = knobs[i];
    const std::optional<Owner> owner = owner_of(session, scene, knob);
    const bool first = !before || before->surface != knob.surface || before->light != knob.light;
    if (owner) {
      label_owner(*owner, first, file);
    } else if (knob.kind != Knob::Kind::toggle) {
      label(knob.label);
    } else if (i % 2 == 1) {
      ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + scaled(toggle_width));
    }
    before = &knob;
    ImGui::PushID(static_cast<int>(i));
    double value = knob.value;
    if (turn(knob, owner ? knob.label : std::string(), value)) turned = TurnedKnob{knob, value};
    ImGui::PopID();
    const std::string name = owner ? fmt::format("{}: {}", owner->name, knob.label) : knob.label;
    add_place(places, side < 0 ? name : fmt::format("{} {}", name, side));
  }
  return turned;
}

}  // namespace penumbra
