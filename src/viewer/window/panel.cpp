#include "viewer/window/panel.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "viewer/window/overlay.hpp"

namespace penumbra {
namespace {

using Places = std::vector<KnobPlace>;

// Notes where the widget before it is.
void note(Places& places, const std::string& label) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  // A label may stand at the right of it.
  places.push_back(
      {label, static_cast<int>(low.x + std::min(high.x - low.x, 20.0f) / 2), static_cast<int>((low.y + high.y) / 2)});
}

// A number of the scene, above `low`, dragged in steps that fit its size. True if it was changed.
bool drag(Places& places, const std::string& label, double& value, double low, double high = 1e6) {
  const auto speed = static_cast<float>(std::max(std::abs(value) * 0.01, 0.002));
  const bool changed = ImGui::DragScalar(label.c_str(), ImGuiDataType_Double, &value, speed, &low, &high, "%.4g",
                                         ImGuiSliderFlags_AlwaysClamp);
  note(places, label);
  return changed;
}

void draw_rays(Places& places, Session& session, const Knobs& knobs) {
  int limit = static_cast<int>(knobs.limit);
  ImGui::SetNextItemWidth(110);
  if (ImGui::InputInt("rays per pixel", &limit, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue)) {
    session.set_limit(static_cast<std::uint32_t>(std::clamp(limit, 0, 1 << 24)));
  }
  note(places, "rays per pixel");
  ImGui::TextDisabled(knobs.limit == 0 ? "0: as long as you look" : "the scene says %d",
                      session.scene()->settings.rays_per_pixel);
}

void draw_camera(Places& places, Session& session, const Knobs& knobs) {
  double radius = knobs.lens_radius, distance = knobs.focus_distance;
  const bool lens = drag(places, "lens radius", radius, 0);
  const bool focus = drag(places, "focus distance", distance, 1e-6);
  if (lens || focus) session.set_lens(radius, distance);
  double open = knobs.shutter_open, close = knobs.shutter_close;
  const bool opens = drag(places, "shutter opens", open, -1e6);
  const bool closes = drag(places, "shutter closes", close, -1e6);
  if (opens || closes) session.set_shutter(open, close);
}

void draw_lights(Places& places, Session& session, const Scene& scene) {
  for (std::size_t i = 0; i < scene.lights.size(); i++) {
    const auto* disk = std::get_if<DiskLight>(&scene.lights[i]);
    if (!disk) continue;
    double radius = disk->radius;
    const int number = static_cast<int>(i) + 1;
    if (drag(places, fmt::format("disk radius, light {}", number), radius, 0)) session.set_disk_radius(number, radius);
  }
}

void draw_surfaces(Places& places, Session& session, const Scene& scene) {
  for (std::size_t i = 0; i < scene.surfaces.size(); i++) {
    const Surface& surface = scene.surfaces[i];
    const int number = static_cast<int>(i) + 1;
    double gloss = surface.gloss_radius, blur = surface.blur_radius;
    if (surface.reflection != 0 && drag(places, fmt::format("gloss, surface {}", number), gloss, 0)) {
      session.set_gloss(number, gloss);
    }
    if (surface.transmission != 0 && drag(places, fmt::format("blur, surface {}", number), blur, 0)) {
      session.set_blur(number, blur);
    }
  }
}

void draw_sampling(Places& places, Session& session, const Knobs& knobs) {
  std::uint32_t seed = knobs.seed;
  const std::uint32_t one = 1;
  if (ImGui::InputScalar("seed", ImGuiDataType_U32, &seed, &one)) session.set_seed(seed);
  note(places, "seed");
  int depth = knobs.max_depth;
  if (ImGui::SliderInt("max depth", &depth, 0, 20)) session.set_max_depth(std::clamp(depth, 0, most_depth));
  note(places, "max depth");
}

// The sampler and the effects of one picture.
void draw_side(Places& places, Session& session, int side) {
  ImGui::PushID(side);
  const Pattern now = session.sampler(side);
  const bool open = ImGui::BeginCombo("sampler", pattern_names[static_cast<int>(now)].data());
  note(places, fmt::format("sampler {}", side));
  if (open) {
    for (int i = 0; i < static_cast<int>(std::size(pattern_names)); i++) {
      const auto pattern = static_cast<Pattern>(i);
      if (ImGui::Selectable(pattern_names[i].data(), pattern == now)) session.set_sampler(side, pattern);
    }
    ImGui::EndCombo();
  }
  for (int i = 0; i < effect_count; i++) {
    const auto effect = static_cast<Effect>(i);
    bool with = !session.options(side).without.has(effect);
    if (ImGui::Checkbox(effect_names[i].data(), &with)) session.toggle_effect(side, effect);
    note(places, fmt::format("{} {}", effect_names[i], side));
  }
  ImGui::PopID();
}

Places draw_knobs(Session& session) {
  Places places;
  const Knobs knobs = session.knobs();
  PictureOptions options = session.options(0);
  options.without = {};
  const Scene scene = with_options(*session.scene(), options);
  draw_rays(places, session, knobs);
  ImGui::Separator();
  draw_camera(places, session, knobs);
  draw_lights(places, session, scene);
  draw_surfaces(places, session, scene);
  ImGui::Separator();
  draw_sampling(places, session, knobs);
  for (int side = 0; side < session.side_count(); side++) {
    if (session.split()) ImGui::TextDisabled(side == 0 ? "left" : "right");
    draw_side(places, session, side);
  }
  ImGui::Separator();
  if (ImGui::Button("As in the file")) session.forget_changes();
  note(places, "As in the file");
  ImGui::SameLine();
  ImGui::TextDisabled("H: keys");
  return places;
}

}  // namespace

std::vector<KnobPlace> draw_panel(Session& session, int window_width, int window_height) {
  ImGui::SetNextWindowPos({static_cast<float>(window_width - panel_width), 0});
  ImGui::SetNextWindowSize({static_cast<float>(panel_width), static_cast<float>(window_height - status_height)});
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
