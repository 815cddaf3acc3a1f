// Parses numbers, lists of numbers, durations and names, as options, Slurm and file formats write them.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace penumbra {

// The number that is the whole text; none for any other text.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  return error == std::errc{} && end == last ? std::optional(number) : std::nullopt;
}

// The numbers of "AxB" or "A,B,C,D"; empty if the text is anything else.
std::vector<int> whole_numbers(std::string_view text, char separator);
std::vector<double> numbers(std::string_view text, char separator);

// The seconds of "90s", "1.5m" (also "min"), "2h" or "1d"; a number alone is in units of `plain_unit` seconds. None for
// any other text, and for what is not above 0.
std::optional<double> seconds_from(std::string_view text, double plain_unit);

// The bytes of "500M", "4G" or "1.5T", in powers of 1024; B may follow. None for any other text, and for what is not at
// least 1 MB.
std::optional<std::uint64_t> bytes_from(std::string_view text);

// The value of an enumeration whose names are listed in its order; none if the text is not one of them.
template <class Enum>
std::optional<Enum> value_named(std::string_view text, std::span<const std::string_view> names) {
  const auto found = std::find(names.begin(), names.end(), text);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
}

}  // namespace penumbra
