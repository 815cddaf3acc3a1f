#include "picture/plain_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/parse.hpp"

namespace penumbra {
namespace {

// A sum with 0 is never -0.
double number_in(const std::string& text, double value) { return number_from<double>(text).value_or(value) + 0.0; }

}  // namespace

double with_digits(double value, int digits) { return number_in(fmt::format("{:.{}e}", value, digits - 1), value); }

double with_decimals(double value, int decimals) { return number_in(fmt::format("{:.{}f}", value, decimals), value); }

std::string with_short_numbers(std::string_view text) {
  constexpr std::string_view ends = " ,;:\n";
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(ends), text.size());
    const std::string_view word = text.substr(0, end);
    const std::optional<double> number = number_from<double>(word);
    const bool is_whole = word.find_first_of(".e") == word.npos;
    result += number && !is_whole ? fmt::format("{}", with_digits(*number, 4)) : std::string(word);
    if (end < text.size()) result += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace penumbra
