#include "language/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace penumbra::detail {
namespace {

// Whether a number outside the range of double is too large rather than too small, judged from its digits alone.
bool is_huge(const char* first, const char* last) {
  const char* const mantissa_end = std::find_if(first, last, [](char c) { return c == 'e' || c == 'E'; });
  const char* const point = std::find(first, mantissa_end, '.');
  const char* const leading = std::find_if(first, mantissa_end, [](char c) { return c >= '1' && c <= '9'; });
  std::int64_t exponent = leading < point ? point - leading : point - leading + 1;
  if (mantissa_end != last) {
    const char* p = mantissa_end + 1;
    const bool down = *p == '-';
    if (*p == '-' || *p == '+') p++;
    std::int64_t power = 0;
    for (; p != last; p++) power = power < 1'000'000'000'000 ? power * 10 + (*p - '0') : power;
    exponent += down ? -power : power;
  }
  return exponent > 0;
}

}  // namespace

NumberError exact_number(const char* first, const char* last, double& value) {
  if (*first == '+') first++;
  const auto [end, code] = std::from_chars(first, last, value, std::chars_format::general);
  if (code == std::errc::result_out_of_range) {
    if (is_huge(first, last)) return NumberError::too_large;
    value = *first == '-' ? -0.0 : 0.0;
    return NumberError::none;
  }
  if (code != std::errc{} || end != last) return NumberError::not_a_number;
  return std::abs(value) > largest_number ? NumberError::too_large : NumberError::none;
}

}  // namespace penumbra::detail
