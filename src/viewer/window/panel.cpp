#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/option_table.hpp"
#include "viewer/window/drawing.hpp"
#include "viewer/window/knobs.hpp"

namespace penumbra {
namespace {

// A heading of the panel and the options whose knobs stand below it. With `each_side`, each half of a split view has
// its own.
struct Section {
  std::string_view heading;
  std::vector<std::string_view> options;
  bool each_side = false;
};

const std::array<Section, 6>& sections() {
  static const std::array<Section, 6> all = {{{"Camera", {"lens", "shutter"}},
                                              {"Lights", {"disk-radius"}},
                                              {"Surfaces", {"gloss", "blur"}},
                                              {"Rays", {"max-depth", "seed"}},
                                              {"Samples", {"sampler"}, true},
                                              {"Effects", {"without"}, true}}};
  return all;
}

void heading(std::string_view text) {
  ImGui::Dummy(place(0, scaled(5)));
  ImGui::PushFont(font(Font::heading));
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
}

void draw_scenes(Drawn& drawn, Session& session) {
  const float button = ImGui::GetFrameHeight();
  const auto step = [&](const char* label, ImGuiDir direction, int by) {
    if (ImGui::ArrowButton(label, direction)) session.execute({ViewCommandKind::next_scene, by}, {});
    add_place(drawn.knobs, label);
  };
  step("previous scene", ImGuiDir_Left, -1);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
  const std::string now = session.path().filename().string();
  const bool open = ImGui::BeginCombo("##scene", now.c_str(), ImGuiComboFlags_HeightLarge);
  add_place(drawn.knobs, "scene");
  if (open) {
    close_with_escape();
    for (const std::filesystem::path& scene : session.scenes()) {
      const bool is_shown = scene == session.path();
      if (ImGui::Selectable(scene.filename().string().c_str(), is_shown) && !is_shown) session.open(scene);
      add_place(drawn.knobs, scene.filename().string());
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  step("next scene", ImGuiDir_Right, 1);
}

void draw_warnings(const Session& session) {
  constexpr std::size_t most = 3;
  ImGui::PushStyleColor(ImGuiCol_Text, colors::accent);
  const float width = ImGui::GetContentRegionAvail().x;
  const std::vector<Diagnostic>& warnings = session.warnings();
  for (std::size_t i = 0; i < std::min(most, warnings.size()); i++) {
    const std::string line = warnings[i].line > 0 ? fmt::format("line {}: ", warnings[i].line) : std::string();
    ImGui::TextUnformatted(wrapped(Font::text, line + warnings[i].message, width).c_str());
  }
  if (warnings.size() > most) ImGui::Text("and %zu more; `penumbra check` lists them", warnings.size() - most);
  ImGui::PopStyleColor();
}

void draw_rays(Drawn& drawn, Session& session) {
  int limit = static_cast<int>(session.limit());
  label("rays per pixel");
  if (ImGui::InputInt("##rays", &limit, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue)) {
    session.set_limit(static_cast<std::uint32_t>(std::clamp(limit, 0, most_rays_per_pixel)));
  }
  add_place(drawn.knobs, "rays per pixel");
  const int own = session.scene()->settings.rays_per_pixel;
  if (static_cast<int>(session.limit()) != own) ImGui::TextDisabled("the scene says %d", own);
}

// The camera as lines of the scene, once the mouse has moved it.
void draw_camera(Drawn& drawn, Session& session) {
  bool moves = session.moves_camera();
  if (ImGui::Checkbox("the mouse moves the camera", &moves)) session.execute({ViewCommandKind::camera}, {});
  add_place(drawn.knobs, "camera");
  const std::string lines = session.camera_lines();
  if (lines.empty()) return;
  ImGui::PushFont(font(Font::mono));
  ImGui::TextDisabled("%s", wrapped(Font::mono, lines, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopFont();
}

void apply(Session& session, const Section& section, int side, const TurnedKnob& turned) {
  const auto set = [&](PictureOptions& options) { turned.knob.set(options, turned.value); };
  if (section.each_side) {
    session.change_side(side, set);
  } else {
    session.change(set);
  }
}

void draw_section(Drawn& drawn, Session& session, const Section& section, int side) {
  const Scene scene = section.each_side ? session.changed_scene(side) : session.scene_with_all_effects();
  std::vector<Knob> knobs;
  for (const std::string_view name : section.options) {
    for (Knob& knob : option_named(name).knobs(scene, session.options(side))) knobs.push_back(std::move(knob));
  }
  if (knobs.empty()) return;
  std::stable_sort(knobs.begin(), knobs.end(), [](const Knob& a, const Knob& b) { return a.surface < b.surface; });
  heading(section.each_side && session.split() ? fmt::format("{}, {}", section.heading, side == 0 ? "left" : "right")
                                               : section.heading);
  ImGui::PushID(side);
  if (const auto turned = draw_knobs(drawn.knobs, session, scene, knobs, section.each_side ? side : -1)) {
    apply(session, section, side, *turned);
  }
  ImGui::PopID();
}

void draw_buttons(Drawn& drawn, Session& session) {
  ImGui::Dummy(place(0, scaled(5)));
  if (ImGui::Button("As in the file")) session.forget_changes();
  add_place(drawn.knobs, "As in the file");
  ImGui::SameLine();
  if (ImGui::Button("Copy changes")) copy_changes(session);
  add_place(drawn.knobs, "Copy changes");
}

void draw_contents(Drawn& drawn, Session& session) {
  draw_scenes(drawn, session);
  if (!session.scene()) return;
  draw_warnings(session);
  draw_rays(drawn, session);
  for (const Section& section : sections()) {
    for (int side = 0; side < (section.each_side ? session.side_count() : 1); side++) {
      draw_section(drawn, session, section, side);
    }
    if (section.heading == "Camera") draw_camera(drawn, session);
  }
  draw_buttons(drawn, session);
}

}  // namespace

void copy_changes(Session& session) {
  const std::string lines = session.changed_lines();
  if (lines.empty()) return session.say("nothing has been changed");
  ImGui::SetClipboardText(lines.c_str());
  session.say("copied:\n" + lines);
}

void draw_panel(Session& session, Drawn& drawn) {
  const float width = scaled(panel_width);
  ImGui::SetNextWindowPos({static_cast<float>(drawn.width) - width, 0});
  ImGui::SetNextWindowSize({width, static_cast<float>(drawn.height)});
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoNav;
  if (ImGui::Begin("panel", nullptr, flags)) draw_contents(drawn, session);
  ImGui::End();
}

}  // namespace penumbra
