// Text as a word of a shell script, whatever it holds.
#pragma once

#include <string>
#include <vector>

namespace penumbra {

std::string shell_word(const std::string& text);

// With spaces in between.
std::string shell_words(const std::vector<std::string>& texts);

}  // namespace penumbra
