// The commands that keys give to the window. Digits are recognised by the position of the key, so that every layout
// works; letters by what is printed on the key, or by its position if that is not a Latin letter; `+`, `-` and `?` by
// the text they type.
#pragma once

#include <cstdint>
#include <string_view>

#include "picture/effect.hpp"

namespace penumbra {

enum class ViewCommandKind {
  none,
  load_scene,  // `number`, and `twin`
  next_scene,  // by `number` places in the folder
  help,
  pause,
  restart,
  save,
  copy,
  focus,
  split,
  camera,
  brighter,
  darker,
  next_sampler,
  toggle_effect,  // `effect`
  more_rays,
  fewer_rays,
  step_sample,  // of the inspected pixel, by `number`
  escape,       // closes what is open, or else the window
  quit
};

struct ViewCommand {
  ViewCommandKind kind = ViewCommandKind::none;
  int number = 0;
  bool twin = false;
  Effect effect = Effect::antialiasing;

  bool operator==(const ViewCommand&) const = default;
};

// A line of the help overlay.
struct KeyHelp {
  const char* keys;
  const char* meaning;
};

inline constexpr KeyHelp key_help[] = {
    {"1 .. 9", "scene s01a.cli .. s09a.cli; with Shift its twin, s01b.cli .. s09b.cli"},
    {"N, Shift+N", "next and previous scene of the folder"},
    {"H or ?", "this help"},
    {"Space", "pause and resume"},
    {"R", "read the scene again and start from scratch"},
    {"+ and -", "twice or half as many rays per pixel"},
    {"S", "save the picture as a PNG"},
    {"C", "copy the changed settings as lines of the scene language"},
    {"F", "focus the lens at the cursor"},
    {"P", "next sampler"},
    {"A L M D G T", "switch on and off: antialiasing, lens, motion, disk lights, gloss, translucency"},
    {"V", "split view: P and the effects change the right half; drag the divider"},
    {"E, Shift+E", "brighter, darker"},
    {"wheel, drag", "zoom and pan the picture"},
    {"O", "the mouse moves the camera: drag turns it, Shift and drag moves it, the wheel brings it nearer"},
    {"click", "what that pixel saw; the arrow keys step through its samples"},
    {"Esc", "close what is open: help, what a pixel saw, the camera; then the window"}};

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
