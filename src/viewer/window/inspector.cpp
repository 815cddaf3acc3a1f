#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "picture/plain_number.hpp"
#include "rendering/ray_colors.hpp"
#include "viewer/inspector_area.hpp"
#include "viewer/projection.hpp"
#include "viewer/window/boxes.hpp"
#include "viewer/window/drawing.hpp"

namespace penumbra {
namespace {

constexpr double margin = 10, most_height = 330;
constexpr double largest_plot = 116, smallest_plot = 60;
constexpr std::size_t most_lines = 200;  // of rays
constexpr ImU32 chosen_color = colors::accent;
constexpr ImU32 casing_color = IM_COL32(255, 255, 255, 150);  // round the lines of rays, so that they show everywhere

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
    const ImU32 color = color_of(color_of(ray).rgb);
    list.AddLine(place(from.x, from.y), place(to.x, to.y), casing_color, scaled(3.6));
    list.AddLine(place(from.x, from.y), place(to.x, to.y), color, scaled(2));
    if (!ray.hit) continue;
    list.AddCircleFilled(place(to.x, to.y), scaled(4), casing_color);
    list.AddCircleFilled(place(to.x, to.y), scaled(3), color);
  }
  const PlaceInWindow corner = view.in_window(inspection.at.x, inspection.at.y);
  const double size = std::max(view.zoom_factor(), 3.0);
  list.AddRect(place(corner.x - 2, corner.y - 2), place(corner.x + size + 2, corner.y + size + 2), colors::background);
  list.AddRect(place(corner.x - 1, corner.y - 1), place(corner.x + size + 1, corner.y + size + 1), chosen_color);
  list.PopClipRect();
}

void draw_plot(const DotPlot& plot, std::uint32_t chosen, float size) {
  ImGui::BeginGroup();
  ImGui::TextDisabled("%s", plot.name.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + size, corner.y + size}, IM_COL32(12, 12, 12, 255), scaled(3));
  const auto at = [&](const SampleDot& dot) {
    const double scale = size / (1 - plot.low);
    return place(corner.x + (dot.u - plot.low) * scale, corner.y + (dot.v - plot.low) * scale);
  };
  const auto byte = [](float value) { return static_cast<int>(255 * std::clamp(value, 0.15f, 1.0f)); };
  for (const SampleDot& dot : plot.dots) {
    list.AddCircleFilled(at(dot), scaled(2), IM_COL32(byte(dot.color[0]), byte(dot.color[1]), byte(dot.color[2]), 255));
    if (dot.sample == chosen) list.AddCircle(at(dot), scaled(5), chosen_color, 0, scaled(1.5));
  }
  ImGui::Dummy({size, size});
  ImGui::EndGroup();
}

// The plots, in a column of its own to the left. Returns its width.
void draw_plots(const Inspection& inspection, float height) {
  const float name = ImGui::GetTextLineHeightWithSpacing();
  const float size = std::clamp(height - name - scaled(4), scaled(smallest_plot), scaled(largest_plot));
  const float step = size + ImGui::GetStyle().ItemSpacing.x;
  const float all = step * static_cast<float>(inspection.plots.size());
  const float width = std::min(all, ImGui::GetContentRegionAvail().x / 2);
  ImGui::BeginChild("plots", {width, height});
  const int columns = std::max(static_cast<int>((width + 1) / step), 1);
  for (std::size_t i = 0; i < inspection.plots.size(); i++) {
    if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine();
    draw_plot(inspection.plots[i], inspection.at.sample, size);
  }
  ImGui::EndChild();
}

// The text with the names of lights and surfaces in place of their numbers.
std::string with_names(const Session& session, std::string text) {
  const auto replace = [&text](std::string_view word, auto&& name_of) {
    const std::size_t at = text.find(word);
    if (at == text.npos) return;
    std::size_t end = at + word.size();
    int number = 0;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') number = 10 * number + (text[end++] - '0');
    text.replace(at, end - at, name_of(number));
  };
  replace("light ", [&](int number) { return session.name_of_light(number); });
  replace("surface ", [&](int number) { return session.name_of_surface(number); });
  return text;
}

void text_in_lines(const std::string& text) {
  ImGui::TextUnformatted(wrapped(Font::text, text, ImGui::GetContentRegionAvail().x).c_str());
}

void draw_ray(const Session& session, const RecordedRay& ray, std::string_view text) {
  const float dot = std::floor(ImGui::GetFontSize() * 0.3f);
  const float indent = scaled(12) * static_cast<float>(ray.depth) + 1;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle = {at.x + dot + 1, at.y + ImGui::GetFontSize() / 2};
  list.AddCircleFilled(middle, dot, color_of(color_of(ray).rgb));
  list.AddCircle(middle, dot, IM_COL32(255, 255, 255, 110));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 2 * dot + scaled(8));
  text_in_lines(with_names(session, with_short_numbers(text.substr(text.find_first_not_of(' ')))));
}

// The text of the inspection, wrapped, each ray with a dot of its colour.
void draw_text(const Session& session, const Inspection& inspection) {
  ImGui::BeginChild("rays", {0, 0});
  const std::vector<BoxLine> lines = lines_of(inspection.text);
  const std::size_t rays = inspection.tree.rays.size();
  for (std::size_t i = 0; i < std::min(rays, most_lines) && i + 1 < lines.size(); i++) {
    draw_ray(session, inspection.tree.rays[i], lines[i + 1].text);
  }
  if (rays > most_lines) ImGui::TextDisabled("... and %zu more rays", rays - most_lines);
  if (!lines.empty()) text_in_lines(with_short_numbers(lines.back().text));
  ImGui::PushStyleColor(ImGuiCol_Text, colors::quiet);
  text_in_lines("With every digit: " + inspection.command);
  ImGui::PopStyleColor();
  ImGui::EndChild();
}

void draw_heading(const Session& session, const Inspection& inspection) {
  const InspectedSample& at = inspection.at;
  const auto& [red, green, blue] = inspection.so_far;
  ImGui::PushFont(font(Font::heading));
  ImGui::Text("Pixel %d, %d", at.x, at.y);
  ImGui::PopFont();
  ImGui::SameLine();
  std::string text = fmt::format("mean {:.4g} {:.4g} {:.4g}; sample {} of {}, stepped by the arrow keys", red, green,
                                 blue, at.sample, session.picture()->rays);
  if (inspection.shown < session.picture()->rays) text += fmt::format("; the first {} are plotted", inspection.shown);
  text_in_lines(text);
}

}  // namespace

void draw_inspector(const Session& session, Drawn& drawn) {
  const auto& inspection = session.inspection();
  if (!inspection || !session.picture()) return;
  draw_rays(session, *inspection);
  const PlaceInWindow pixel = session.view().in_window(inspection->at.x + 0.5, inspection->at.y + 0.5);
  const WindowArea area =
      inspector_area(session.view(), pixel, static_cast<int>(scaled(margin)), static_cast<int>(scaled(most_height)));
  ImGui::SetNextWindowPos(place(area.x, area.y));
  ImGui::SetNextWindowSize(place(area.width, area.height));
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                     ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, place(1, 1));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colors::box);
  if (ImGui::Begin("inspector", nullptr, flags)) {
    draw_heading(session, *inspection);
    draw_plots(*inspection, ImGui::GetContentRegionAvail().y);
    ImGui::SameLine();
    draw_text(session, *inspection);
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  drawn.inspector = area;
}

}  // namespace penumbra
