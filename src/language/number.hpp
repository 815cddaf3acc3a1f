// Decimal numbers as the scene language and the text mesh formats write them: `2`, `-2`, `+2`, `.5`, `2.`, `1e-3`. The
// same in every locale. Correctly rounded: a mantissa up to 2^53 with a power of ten up to 22 needs one operation on
// exact operands (Clinger 1990); everything else goes to std::from_chars. `nan`, `inf` and hexadecimal are not numbers.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace penumbra {

// Every number must be finite in single precision, in which pictures are computed.
inline constexpr double largest_number = std::numeric_limits<float>::max();

enum class NumberError : std::uint8_t { none, not_a_number, too_large };

struct ParsedNumber {
  const char* end;    // one past the last character of the number
  NumberError error;  // not_a_number if the text does not start with one
};

namespace detail {

inline constexpr std::array<double, 23> power_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

inline bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

// The value of [first, last), which is known to be a decimal number.
NumberError exact_number(const char* first, const char* last, double& value);

}  // namespace detail

// Reads the longest number at the start of [first, last) into `value`.
inline ParsedNumber parse_number(const char* first, const char* last, double& value) {
  using detail::is_digit;
  const char* p = first;
  bool negative = false;
  if (p != last && (*p == '-' || *p == '+')) negative = *p++ == '-';
  std::uint64_t mantissa = 0;  // wraps for more than 19 digits, which take the slow path below
  const char* const whole = p;
  while (p != last && is_digit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
  std::int64_t digits = p - whole;
  std::int64_t exponent = 0;
  if (p != last && *p == '.') {
    const char* const fraction = ++p;
    while (p != last && is_digit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
    exponent = fraction - p;
    digits -= exponent;
  }
  if (digits == 0) return {first, NumberError::not_a_number};
  if (p != last && (*p == 'e' || *p == 'E')) {
    const char* q = p + 1;
    bool down = false;
    if (q != last && (*q == '-' || *q == '+')) down = *q++ == '-';
    if (q == last || !is_digit(*q)) return {first, NumberError::not_a_number};
    std::int64_t power = 0;
    for (; q != last && is_digit(*q); q++) power = power < 1'000'000'000 ? power * 10 + (*q - '0') : power;
    exponent += down ? -power : power;
    p = q;
  }
  if (digits <= 19 && mantissa <= (std::uint64_t{1} << 53) && exponent >= -22 && exponent <= 22) {
    const double scale = detail::power_of_ten[static_cast<std::size_t>(exponent < 0 ? -exponent : exponent)];
    const double magnitude =
        exponent < 0 ? static_cast<double>(mantissa) / scale : static_cast<double>(mantissa) * scale;
    value = negative ? -magnitude : magnitude;
    return {p, magnitude > largest_number ? NumberError::too_large : NumberError::none};
  }
  return {p, detail::exact_number(first, p, value)};
}

// The same for a whole word: anything after the number is an error.
inline NumberError parse_number(std::string_view word, double& value) {
  const ParsedNumber parsed = parse_number(word.data(), word.data() + word.size(), value);
  return parsed.end == word.data() + word.size() ? parsed.error : NumberError::not_a_number;
}

}  // namespace penumbra
