#include "farm/slurm_time.hpp"

#include <charconv>
#include <vector>

namespace penumbra {
namespace {

constexpr int longest = 366 * 24 * 60 * 60;  // seconds

// The numbers between the separators; empty if anything else is there.
std::vector<int> numbers_of(std::string_view text, char separator) {
  std::vector<int> numbers;
  for (;;) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || number < 0 || number > longest) return {};
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.empty()) return numbers;
    if (text.front() != separator) return {};
    text.remove_prefix(1);
  }
}

// Seconds of "5", "5m" and the like; 0 for any other text.
double seconds_with_unit(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !(number > 0)) return 0;
  const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  if (unit == "s") return number;
  if (unit == "m" || unit == "min" || unit.empty()) return 60 * number;
  if (unit == "h") return 3600 * number;
  return unit == "d" ? 86400 * number : 0;
}

double seconds_of(std::string_view text) {
  const std::size_t dash = text.find('-');
  if (dash != text.npos) {
    const std::vector<int> days = numbers_of(text.substr(0, dash), ':'), rest = numbers_of(text.substr(dash + 1), ':');
    if (days.size() != 1 || rest.empty() || rest.size() > 3) return 0;
    double seconds = 86400.0 * days[0], unit = 3600;
    for (const int number : rest) {
      seconds += unit * number;
      unit /= 60;
    }
    return seconds;
  }
  if (text.find(':') == text.npos) return seconds_with_unit(text);
  const std::vector<int> numbers = numbers_of(text, ':');
  if (numbers.empty() || numbers.size() > 3) return 0;
  double seconds = 0;
  for (const int number : numbers) seconds = 60 * seconds + number;
  return seconds;
}

}  // namespace

std::optional<int> slurm_minutes(std::string_view text) {
  const double seconds = seconds_of(text);
  if (!(seconds > 0) || seconds > longest) return std::nullopt;
  return static_cast<int>((seconds + 59.999) / 60);
}

}  // namespace penumbra
