// Quotes any text as one word of a shell script.
#pragma once

#include <string>
#include <vector>

namespace penumbra {

std::string shell_word(const std::string& text);

// The quoted texts with spaces in between.
std::string shell_words(const std::vector<std::string>& texts);

}  // namespace penumbra
