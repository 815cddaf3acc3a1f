// Guesses which known word was meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

// The number of letters to insert, remove, replace or swap with a neighbour to get from one word to the other, ignoring
// case (optimal string alignment distance).
int edit_distance(std::string_view a, std::string_view b);

// The known word nearest to `word`, the first of several equally near; empty if none is near.
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known);

// "did you mean `sphere`?", or nothing if there is no such word.
std::string did_you_mean(std::string_view word);

}  // namespace penumbra
