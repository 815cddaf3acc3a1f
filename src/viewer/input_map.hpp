// From keys to commands. Digits are told by the key's place on the keyboard, so that every layout works; letters by
// what is printed on the key, or by its place where that is no Latin letter; `+`, `-` and `?` by the text they type.
#pragma once

#include <cstdint>
#include <string_view>

#include "viewer/command.hpp"

namespace penumbra {

// A key that went down, in SDL's numbers.
struct PressedKey {
  int scancode = 0;
  std::int32_t keycode = 0;
  bool shift = false;
  bool other_modifier = false;  // Ctrl, Alt or the system's own key
  bool repeated = false;        // by being held down
};

ViewCommand command_of_key(const PressedKey& key);

// What a typed character asks for.
ViewCommand command_of_text(std::string_view text);

}  // namespace penumbra
