// Option values as text: reading and writing shared by the rows of the option table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "picture/picture_options.hpp"

namespace penumbra {

// The names, separated by ", ".
std::string listed(std::span<const std::string_view> names);

inline constexpr double farthest_time = 1e6;
inline constexpr double largest_radius = 1e9;

// "expected ...; found `text`".
std::string expected(std::string_view text, std::string_view what);
// "there is no pattern `text`; there are ...".
std::string unknown(std::string_view what, std::string_view text, std::string_view names);

// Parse a decimal number from `low` to `high`. Return what is wrong with the text, leaving `value` unchanged; empty if
// nothing is.
std::string parse_whole(std::string_view text, std::int64_t low, std::int64_t high, std::int64_t& value);
std::string parse_number(std::string_view text, double low, double high, std::string_view what,
                         std::optional<double>& value);
template <class Number>
std::string parse_whole(std::string_view text, std::int64_t low, std::int64_t high, std::optional<Number>& value) {
  std::int64_t number = 0;
  std::string wrong = parse_whole(text, low, high, number);
  if (wrong.empty()) value = static_cast<Number>(number);
  return wrong;
}

// "A-B" or "A-BxSTEP".
std::string parse_frames(std::string_view text, std::optional<AnimationRange>& range);

// "0.2" applies to all, "3:0.2" to number 3.
std::string parse_radius(std::string_view text, std::vector<NumberedRadius>& radii);
std::string radii_in_words(const std::vector<NumberedRadius>& radii);

}  // namespace penumbra
