#include "picture/option_text.hpp"

#include <fmt/ranges.h>

namespace penumbra {
namespace {

std::optional<AnimationRange> range_from(std::string_view text) {
  const std::size_t x = text.find('x');
  const std::string_view range = text.substr(0, x);
  std::vector<int> ends = whole_numbers(range, '-');
  if (const auto one = number_from<int>(text)) ends = {*one, *one};
  const int step = x == text.npos ? 1 : number_from<int>(text.substr(x + 1)).value_or(0);
  if (ends.size() != 2 || ends[0] < 0 || ends[0] > ends[1] || ends[1] > last_possible_frame || step < 1) {
    return std::nullopt;
  }
  return AnimationRange{ends[0], ends[1], step};
}

}  // namespace

std::string listed(std::span<const std::string_view> names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string expected(std::string_view text, std::string_view what) {
  return fmt::format("expected {}; found `{}`", what, text);
}

std::string unknown(std::string_view what, std::string_view text, std::string_view names) {
  return fmt::format("there is no {} `{}`; there are {}", what, text, names);
}

std::string parse_number(std::string_view text, double low, double high, std::string_view what,
                         std::optional<double>& value) {
  const std::vector<double> n = numbers(text, ',');
  if (n.size() != 1 || n[0] < low || n[0] > high) return expected(text, what);
  value = n[0];
  return {};
}

std::string parse_frames(std::string_view text, std::optional<AnimationRange>& range) {
  const std::optional<AnimationRange> found = range_from(text);
  if (!found) {
    return expected(text,
                    fmt::format("A, A-B or A-BxSTEP with 0 <= A <= B <= {} and STEP 1 or more", last_possible_frame));
  }
  range = found;
  return {};
}

std::string parse_radius(std::string_view text, std::vector<NumberedRadius>& radii) {
  const std::size_t colon = text.find(':');
  const bool numbered = colon != text.npos;
  const std::vector<int> number = numbered ? whole_numbers(text.substr(0, colon), ',') : std::vector<int>{0};
  const std::vector<double> radius = numbers(numbered ? text.substr(colon + 1) : text, ',');
  const bool good = number.size() == 1 && (!numbered || number[0] >= 1) && radius.size() == 1 && radius[0] >= 0 &&
                    radius[0] <= largest_radius;
  if (!good) {
    return expected(text, "a radius of 0 or more for all, or NUMBER:RADIUS for one, such as 0.2 or 3:0.2");
  }
  radii.push_back({number[0], radius[0]});
  return {};
}

std::string radii_in_words(const std::vector<NumberedRadius>& radii) {
  std::string text;
  for (const NumberedRadius& radius : radii) {
    if (!text.empty()) text += ',';
    text += radius.number == 0 ? fmt::format("{}", radius.radius) : fmt::format("{}:{}", radius.number, radius.radius);
  }
  return text;
}

}  // namespace penumbra
