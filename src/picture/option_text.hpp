// Option values as text: reading and writing shared by the rows of the option table.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parse.hpp"
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
template <class Value>
std::string parse_whole(std::string_view text, std::int64_t low, std::int64_t high, Value& value) {
  const auto number = number_from<std::int64_t>(text);
  if (!number || *number < low || *number > high) {
    return expected(text, fmt::format("a whole number from {} to {}", low, high));
  }
  value = *number;
  return {};
}
std::string parse_number(std::string_view text, double low, double high, std::string_view what,
                         std::optional<double>& value);

// Parses one of `names`, the values of an enumeration in its order; `what` says in an error what they are.
template <class Enum, class Value>
std::string parse_name(std::string_view what, std::string_view text, std::span<const std::string_view> names,
                       Value& value) {
  const std::optional<Enum> found = value_named<Enum>(text, names);
  if (!found) return unknown(what, text, listed(names));
  value = *found;
  return {};
}

// The words of a row for a number: those of the number if it is given.
template <auto asked>
std::string words_if_given(const PictureOptions& options, const Settings&) {
  return options.*asked ? fmt::format("{}", *(options.*asked)) : std::string();
}

// "A-B" or "A-BxSTEP".
std::string parse_frames(std::string_view text, std::optional<AnimationRange>& range);

// "0.2" applies to all, "3:0.2" to number 3.
std::string parse_radius(std::string_view text, std::vector<NumberedRadius>& radii);
std::string radii_in_words(const std::vector<NumberedRadius>& radii);

}  // namespace penumbra
