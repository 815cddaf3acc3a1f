#include "picture/effect.hpp"

namespace penumbra {

std::optional<Effect> effect_from_name(std::string_view name) {
  for (int i = 0; i < effect_count; i++) {
    if (effect_names[i] == name) return static_cast<Effect>(i);
  }
  return std::nullopt;
}

std::string to_string(Effects effects) {
  std::string text;
  for (int i = 0; i < effect_count; i++) {
    if (!effects.has(static_cast<Effect>(i))) continue;
    if (!text.empty()) text += ',';
    text += effect_names[i];
  }
  return text;
}

}  // namespace penumbra
