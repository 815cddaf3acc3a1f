#include "viewer/window/boxes.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

namespace penumbra {
namespace {

constexpr double padding_x = 14, padding_y = 10, margin = 12, key_gap = 18, rounding = 6;
constexpr double narrowest = 40;

float width_of(ImFont* letters, std::string_view text) {
  return letters->CalcTextSizeA(letters->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
}

// A line that is no wider than its box.
struct Row {
  std::string key, text;
};

std::vector<Row> rows_of(const std::vector<BoxLine>& lines, Font which, float width) {
  std::vector<Row> rows;
  for (const BoxLine& line : lines) {
    std::string key(line.key);
    const std::string text = wrapped(which, line.text, width);
    for (const BoxLine& part : lines_of(text)) rows.push_back({std::exchange(key, {}), std::string(part.text)});
  }
  return rows;
}

}  // namespace

std::vector<BoxLine> lines_of(std::string_view text) {
  std::vector<BoxLine> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back({{}, text.substr(0, end)});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

WindowArea draw_box(const std::vector<BoxLine>& lines, const BoxStyle& style, const WindowArea& bounds, ImVec2 anchor) {
  ImFont* const letters = font(style.font);
  float key_width = 0, text_width = 0;
  for (const BoxLine& line : lines) {
    if (!line.key.empty()) key_width = std::max(key_width, width_of(letters, line.key) + scaled(key_gap));
    text_width = std::max(text_width, width_of(letters, line.text));
  }
  const float most_width = static_cast<float>(bounds.width) - 2 * scaled(margin + padding_x) - key_width;
  const float wrap = std::max(std::ceil(std::min(text_width, most_width)), scaled(narrowest));
  std::vector<Row> rows = rows_of(lines, style.font, wrap);
  const float row_height = std::round(letters->FontSize * 1.2f);
  const float most_height = static_cast<float>(bounds.height) - 2 * scaled(margin + padding_y);
  const auto most_rows = static_cast<std::size_t>(std::max(most_height / row_height, 1.0f));
  if (rows.size() > most_rows) {
    rows.resize(most_rows);
    rows.back() = {{}, "..."};
  }
  const float width = key_width + wrap + 2 * scaled(padding_x);
  const float height = static_cast<float>(rows.size()) * row_height + 2 * scaled(padding_y);
  const float free_x = static_cast<float>(bounds.width) - 2 * scaled(margin) - width;
  const float free_y = static_cast<float>(bounds.height) - 2 * scaled(margin) - height;
  const ImVec2 corner = {std::floor(static_cast<float>(bounds.x) + scaled(margin) + free_x * anchor.x),
                         std::floor(static_cast<float>(bounds.y) + scaled(margin) + free_y * anchor.y)};
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, style.fill, scaled(rounding));
  list.AddRect(corner, {corner.x + width, corner.y + height}, style.line, scaled(rounding));
  const float x = std::floor(corner.x + scaled(padding_x));
  float y = std::floor(corner.y + scaled(padding_y) + (row_height - letters->FontSize) / 2);
  for (const Row& row : rows) {
    list.AddText(letters, letters->FontSize, {x, y}, colors::accent, row.key.c_str());
    list.AddText(letters, letters->FontSize, {x + key_width, y}, colors::text, row.text.c_str());
    y += row_height;
  }
  return {static_cast<int>(corner.x), static_cast<int>(corner.y), static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace penumbra
