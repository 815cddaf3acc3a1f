#include "viewer/input_map.hpp"

#include <SDL_keycode.h>
#include <SDL_scancode.h>

namespace penumbra {
namespace {

// The Latin letter of a key, lower case; 0 if it has none.
char letter_of(const PressedKey& key) {
  if (key.keycode >= SDLK_a && key.keycode <= SDLK_z) return static_cast<char>(key.keycode);
  const bool other_script = key.keycode > 0x7f && (key.keycode & SDLK_SCANCODE_MASK) == 0;
  if (other_script && key.scancode >= SDL_SCANCODE_A && key.scancode <= SDL_SCANCODE_Z) {
    return static_cast<char>('a' + (key.scancode - SDL_SCANCODE_A));
  }
  return 0;
}

ViewCommand toggle(Effect effect) { return {ViewCommandKind::toggle_effect, 0, false, effect}; }

ViewCommand command_of_letter(char letter, bool shift) {
  switch (letter) {
    case 'h':
      return {ViewCommandKind::help};
    case 'r':
      return {ViewCommandKind::restart};
    case 's':
      return {ViewCommandKind::save};
    case 'c':
      return {ViewCommandKind::copy};
    case 'f':
      return {ViewCommandKind::focus};
    case 'v':
      return {ViewCommandKind::split};
    case 'e':
      return {shift ? ViewCommandKind::darker : ViewCommandKind::brighter};
    case 'p':
      return {ViewCommandKind::next_sampler};
    case 'a':
      return toggle(Effect::antialiasing);
    case 'l':
      return toggle(Effect::lens);
    case 'm':
      return toggle(Effect::motion);
    case 'd':
      return toggle(Effect::disk_lights);
    case 'g':
      return toggle(Effect::gloss);
    case 't':
      return toggle(Effect::translucency);
    default:
      return {};
  }
}

ViewCommand step(int samples) { return {ViewCommandKind::step_sample, samples}; }

}  // namespace

ViewCommand command_of_key(const PressedKey& key) {
  if (key.other_modifier) return {};
  switch (key.scancode) {
    case SDL_SCANCODE_LEFT:
      return step(-1);
    case SDL_SCANCODE_RIGHT:
      return step(1);
    case SDL_SCANCODE_UP:
      return step(-16);
    case SDL_SCANCODE_DOWN:
      return step(16);
    default:
      break;
  }
  if (key.repeated) return {};
  if (key.scancode == SDL_SCANCODE_ESCAPE) return {ViewCommandKind::quit};
  if (key.scancode == SDL_SCANCODE_SPACE) return {ViewCommandKind::pause};
  if (key.scancode >= SDL_SCANCODE_1 && key.scancode <= SDL_SCANCODE_9) {
    return {ViewCommandKind::load_scene, key.scancode - SDL_SCANCODE_1 + 1, key.shift};
  }
  return command_of_letter(letter_of(key), key.shift);
}

ViewCommand command_of_text(std::string_view text) {
  if (text == "?") return {ViewCommandKind::help};
  if (text == "+" || text == "=") return {ViewCommandKind::more_rays};
  if (text == "-") return {ViewCommandKind::fewer_rays};
  return {};
}

}  // namespace penumbra
