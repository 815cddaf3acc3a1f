#include "viewer/input_map.hpp"

#include <SDL_keycode.h>
#include <SDL_scancode.h>

#include <algorithm>
#include <iterator>

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

constexpr ViewCommand toggle(Effect effect) { return {ViewCommandKind::toggle_effect, 0, false, effect}; }

struct Letter {
  char letter;
  ViewCommand command;
};

constexpr Letter letters[] = {
    {'h', {ViewCommandKind::help}},         {'r', {ViewCommandKind::restart}},   {'s', {ViewCommandKind::save}},
    {'c', {ViewCommandKind::copy}},         {'f', {ViewCommandKind::focus}},     {'v', {ViewCommandKind::split}},
    {'p', {ViewCommandKind::next_sampler}}, {'a', toggle(Effect::antialiasing)}, {'l', toggle(Effect::lens)},
    {'m', toggle(Effect::motion)},          {'d', toggle(Effect::disk_lights)},  {'g', toggle(Effect::gloss)},
    {'t', toggle(Effect::translucency)},    {'o', {ViewCommandKind::camera}}};

ViewCommand step(int samples) { return {ViewCommandKind::step_sample, samples}; }

}  // namespace

ViewCommand command_of_key(const PressedKey& key) {
  if (key.other_modifier) return {};
  if (key.scancode == SDL_SCANCODE_LEFT) return step(-1);
  if (key.scancode == SDL_SCANCODE_RIGHT) return step(1);
  if (key.scancode == SDL_SCANCODE_UP) return step(-16);
  if (key.scancode == SDL_SCANCODE_DOWN) return step(16);
  if (key.repeated) return {};
  if (key.scancode == SDL_SCANCODE_ESCAPE) return {ViewCommandKind::escape};
  if (key.scancode == SDL_SCANCODE_SPACE) return {ViewCommandKind::pause};
  if (key.scancode >= SDL_SCANCODE_1 && key.scancode <= SDL_SCANCODE_9) {
    return {ViewCommandKind::load_scene, key.scancode - SDL_SCANCODE_1 + 1, key.shift};
  }
  const char letter = letter_of(key);
  if (letter == 'n') return {ViewCommandKind::next_scene, key.shift ? -1 : 1};
  if (letter == 'e') return {key.shift ? ViewCommandKind::darker : ViewCommandKind::brighter};
  const auto* found =
      std::find_if(std::begin(letters), std::end(letters), [&](const Letter& l) { return l.letter == letter; });
  return found != std::end(letters) ? found->command : ViewCommand();
}

ViewCommand command_of_text(std::string_view text) {
  if (text == "?") return {ViewCommandKind::help};
  if (text == "+" || text == "=") return {ViewCommandKind::more_rays};
  if (text == "-") return {ViewCommandKind::fewer_rays};
  return {};
}

}  // namespace penumbra
