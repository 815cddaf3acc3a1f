#include "base/number_list.hpp"

#include <charconv>
#include <cmath>

namespace penumbra {
namespace {

template <typename Number>
std::vector<Number> list_of(std::string_view text, char separator) {
  std::vector<Number> list;
  const char* p = text.data();
  const char* end = p + text.size();
  while (true) {
    Number value = 0;
    const auto result = std::from_chars(p, end, value);
    if (result.ec != std::errc{}) return {};
    list.push_back(value);
    if (result.ptr == end) return list;
    if (*result.ptr != separator) return {};
    p = result.ptr + 1;
  }
}

}  // namespace

std::vector<int> whole_numbers(std::string_view text, char separator) { return list_of<int>(text, separator); }

std::vector<double> numbers(std::string_view text, char separator) {
  std::vector<double> list = list_of<double>(text, separator);
  for (const double value : list) {
    if (!std::isfinite(value)) return {};
  }
  return list;
}

}  // namespace penumbra
