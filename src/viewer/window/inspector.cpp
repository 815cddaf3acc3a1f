#include <algorithm>

#include "viewer/projection.hpp"
#include "viewer/window/drawing.hpp"

namespace penumbra {
namespace {

constexpr float plot_size = 92;
constexpr ImU32 frame_color = IM_COL32(110, 110, 110, 255);
constexpr ImU32 chosen_color = IM_COL32(255, 220, 60, 255);

ImU32 color_of(const RecordedRay& ray) {
  constexpr ImU32 colors[] = {IM_COL32(255, 255, 255, 255), IM_COL32(255, 230, 90, 255), IM_COL32(80, 220, 255, 255),
                              IM_COL32(255, 110, 255, 255)};  // in the order of RayKind
  const bool is_blocked = ray.kind == RayKind::shadow && ray.hit;
  return is_blocked ? IM_COL32(140, 140, 140, 255) : colors[static_cast<std::size_t>(ray.kind)];
}

// How long a ray is drawn.
float length_of(const RecordedRay& ray, float reach) {
  if (ray.hit) return ray.distance;
  return ray.kind == RayKind::shadow ? ray.light_distance : reach;
}

void draw_rays(const Session& session, const Inspection& inspection) {
  const RefinedSide& side = session.picture()->sides[static_cast<std::size_t>(inspection.at.side)];
  const PictureView& view = session.view();
  const WindowArea& area = view.area();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(place(area.x, area.y), place(area.x + area.width, area.y + area.height));
  const PlaceInWindow corner = view.in_window(inspection.at.x, inspection.at.y);
  const double size = std::max(view.zoom_factor(), 3.0);
  list.AddRect(place(corner.x - 1, corner.y - 1), place(corner.x + size + 1, corner.y + size + 1), chosen_color);
  const RecordedRay& eye = inspection.tree.rays.front();
  const float reach = eye.hit ? 4 * eye.distance : 1;
  for (const RecordedRay& ray : inspection.tree.rays) {
    if (ray.kind == RayKind::eye) continue;  // seen end-on
    float end[3];
    for (int i = 0; i < 3; i++) end[i] = ray.origin[i] + ray.direction[i] * length_of(ray, reach);
    const auto line = project_line(side.frame->camera, ray.origin, end);
    if (!line) continue;
    const PlaceInWindow from = view.in_window(line->first.x, line->first.y);
    const PlaceInWindow to = view.in_window(line->second.x, line->second.y);
    list.AddLine(place(from.x, from.y), place(to.x, to.y), color_of(ray), 1.5f);
    if (ray.hit) list.AddCircleFilled(place(to.x, to.y), 3, color_of(ray));
  }
  list.PopClipRect();
}

void draw_plot(const DotPlot& plot, std::uint32_t chosen) {
  ImGui::BeginGroup();
  ImGui::TextUnformatted(plot.name.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end = {corner.x + plot_size, corner.y + plot_size};
  list.AddRectFilled(corner, end, IM_COL32(0, 0, 0, 255));
  list.AddRect(corner, end, frame_color);
  const auto at = [&](const SampleDot& dot) {
    const double scale = plot_size / (1 - plot.low);
    return place(corner.x + (dot.u - plot.low) * scale, corner.y + (dot.v - plot.low) * scale);
  };
  const auto byte = [](float value) { return static_cast<int>(255 * std::clamp(value, 0.15f, 1.0f)); };
  for (const SampleDot& dot : plot.dots) {
    list.AddCircleFilled(at(dot), 2, IM_COL32(byte(dot.color[0]), byte(dot.color[1]), byte(dot.color[2]), 255));
    if (dot.sample == chosen) list.AddCircle(at(dot), 5, chosen_color);
  }
  ImGui::Dummy({plot_size, plot_size});
  ImGui::EndGroup();
}

}  // namespace

std::optional<WindowArea> draw_inspector(const Session& session) {
  const auto& inspection = session.inspection();
  if (!inspection || !session.picture()) return {};
  draw_rays(session, *inspection);
  const WindowArea& area = session.view().area();
  const double height = std::min(340.0, area.height * 0.45);
  // In the half of the window without the pixel.
  const double pixel = session.view().in_window(inspection->at.x, inspection->at.y).y;
  const bool above = pixel > area.y + area.height / 2.0;
  ImGui::SetNextWindowPos(place(area.x + 8, above ? area.y + 8 : area.y + area.height - height - 8),
                          ImGuiCond_Appearing);
  ImGui::SetNextWindowSize(place(std::min(area.width - 16, 720), height), ImGuiCond_Appearing);
  ImGui::SetNextWindowBgAlpha(0.9f);
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_HorizontalScrollbar;
  if (ImGui::Begin("What the pixel saw", nullptr, flags)) {
    for (std::size_t i = 0; i < inspection->plots.size(); i++) {
      if (i > 0) ImGui::SameLine();
      draw_plot(inspection->plots[i], inspection->at.sample);
    }
    const auto& [red, green, blue] = inspection->so_far;
    ImGui::Text("so far %.7g %.7g %.7g, the mean of %u samples", double{red}, double{green}, double{blue},
                session.picture()->rays);
    ImGui::TextDisabled("%u of them above; the arrow keys step through them", inspection->shown);
    ImGui::TextUnformatted(inspection->text.c_str());
    ImGui::TextDisabled("%s", inspection->command.c_str());
  }
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ImGui::End();
  return WindowArea{static_cast<int>(corner.x), static_cast<int>(corner.y), static_cast<int>(size.x),
                    static_cast<int>(size.y)};
}

}  // namespace penumbra
