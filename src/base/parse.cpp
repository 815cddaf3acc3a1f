#include "base/parse.hpp"

#include <cmath>

namespace penumbra {
namespace {

template <typename Number>
std::vector<Number> list_of(std::string_view text, char separator) {
  std::vector<Number> list;
  while (true) {
    const std::size_t end = text.find(separator);
    const std::optional<Number> number = number_from<Number>(text.substr(0, end));
    if (!number || !std::isfinite(static_cast<double>(*number))) return {};
    list.push_back(*number);
    if (end == text.npos) return list;
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::vector<int> whole_numbers(std::string_view text, char separator) { return list_of<int>(text, separator); }
std::vector<double> numbers(std::string_view text, char separator) { return list_of<double>(text, separator); }

std::optional<double> seconds_from(std::string_view text, double plain_unit) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  if (error != std::errc{} || !(number > 0)) return std::nullopt;
  if (unit.empty()) return plain_unit * number;
  if (unit == "s") return number;
  if (unit == "m" || unit == "min") return 60 * number;
  if (unit == "h") return 3600 * number;
  return unit == "d" ? std::optional(86400 * number) : std::nullopt;
}

std::optional<std::uint64_t> bytes_from(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  if (unit.ends_with('B')) unit.remove_suffix(1);
  constexpr std::string_view units = "MGT";
  const std::size_t power = unit.size() == 1 ? units.find(unit.front()) : units.npos;
  if (error != std::errc{} || power == units.npos) return std::nullopt;
  const double bytes = std::ldexp(number, 20 + 10 * static_cast<int>(power));
  return bytes >= 1 << 20 && bytes < 1e18 ? std::optional(static_cast<std::uint64_t>(bytes)) : std::nullopt;
}

}  // namespace penumbra
