#include "sampling/pattern.hpp"

#include <iterator>

namespace penumbra {

std::optional<Pattern> pattern_from_name(std::string_view name) {
  for (std::size_t i = 0; i < std::size(pattern_names); i++) {
    if (pattern_names[i] == name) return static_cast<Pattern>(i);
  }
  return std::nullopt;
}

}  // namespace penumbra
