// Parses short lists of numbers, as options take them.
#pragma once

#include <string_view>
#include <vector>

namespace penumbra {

// The numbers of "AxB" or "A,B,C,D"; empty if the text is anything else.
std::vector<int> whole_numbers(std::string_view text, char separator);
std::vector<double> numbers(std::string_view text, char separator);

}  // namespace penumbra
