// Maps keys to commands. Digits are recognised by the position of the key, so that every layout works; letters by what
// is printed on the key, or by its position if that is not a Latin letter; `+`, `-` and `?` by the text they type.
#pragma once

#include <cstdint>
#include <string_view>

#include "viewer/command.hpp"

namespace penumbra {

// A key that went down, in SDL's codes.
struct PressedKey {
  int scancode = 0;
  std::int32_t keycode = 0;
  bool shift = false;
  bool other_modifier = false;  // Ctrl, Alt or the Super key
  bool repeated = false;        // because it is held down
};

ViewCommand command_of_key(const PressedKey& key);

// The command of a typed character.
ViewCommand command_of_text(std::string_view text);

}  // namespace penumbra
