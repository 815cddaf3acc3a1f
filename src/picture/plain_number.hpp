// Numbers as people write them: 15.05, not 15.049999237060547.
#pragma once

#include <string>
#include <string_view>

namespace penumbra {

// The nearest number with this many significant digits.
double with_digits(double value, int digits);

// The nearest number with this many digits after the point.
double with_decimals(double value, int decimals);

// The text with each decimal number in it shortened to four significant digits; whole numbers stay.
std::string with_short_numbers(std::string_view text);

}  // namespace penumbra
