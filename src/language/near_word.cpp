#include "language/near_word.hpp"

#include <algorithm>

namespace penumbra {
namespace {

constexpr std::size_t longest_word = 64;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// One letter of a short word, a third of the letters of a long one.
int largest_distance(std::size_t length) { return std::max(1, static_cast<int>(length / 3)); }

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<int> before_last(width), last(width), current(width);
  for (std::size_t j = 0; j < width; j++) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); i++) {
    current[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < width; j++) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) current[j] = std::min(current[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(current);
  }
  return last[b.size()];
}

std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known) {
  if (word.size() < 2 || word.size() > longest_word) return {};
  std::string_view nearest;
  int smallest = largest_distance(word.size()) + 1;
  for (const std::string_view candidate : known) {
    const std::size_t shorter = std::min(word.size(), candidate.size());
    const std::size_t longer = std::max(word.size(), candidate.size());
    if (longer > longest_word || longer - shorter >= static_cast<std::size_t>(smallest)) continue;
    const int distance = edit_distance(word, candidate);
    if (distance >= smallest) continue;
    smallest = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string did_you_mean(std::string_view word) {
  return word.empty() ? std::string() : "did you mean `" + std::string(word) + "`?";
}

}  // namespace penumbra
