#include "viewer/input_map.hpp"

#include <SDL_keycode.h>
#include <SDL_scancode.h>
#include <gtest/gtest.h>

namespace penumbra {
namespace {

using enum ViewCommandKind;

ViewCommandKind kind_of(int scancode, int keycode, bool shift = false) {
  return command_of_key({scancode, keycode, shift}).kind;
}

TEST(InputMap, DigitsGoByThePlaceOfTheKey) {
  EXPECT_EQ(command_of_key({SDL_SCANCODE_3, SDLK_3}), (ViewCommand{load_scene, 3, false}));
  EXPECT_EQ(command_of_key({SDL_SCANCODE_9, '!', true}), (ViewCommand{load_scene, 9, true}));
  EXPECT_EQ(kind_of(SDL_SCANCODE_0, SDLK_0), none);
}

TEST(InputMap, LettersGoByWhatIsPrinted) {
  EXPECT_EQ(command_of_key({SDL_SCANCODE_Q, SDLK_a}).effect, Effect::antialiasing) << "AZERTY";
  EXPECT_EQ(kind_of(SDL_SCANCODE_A, SDLK_q), none) << "AZERTY";
  EXPECT_EQ(kind_of(SDL_SCANCODE_S, 0x44b), save) << "a Cyrillic letter: by its position";
  EXPECT_EQ(kind_of(SDL_SCANCODE_E, SDLK_e), brighter);
  EXPECT_EQ(kind_of(SDL_SCANCODE_E, SDLK_e, true), darker);
}

TEST(InputMap, EveryKeyOfTheContract) {
  EXPECT_EQ(kind_of(SDL_SCANCODE_H, SDLK_h), help);
  EXPECT_EQ(kind_of(SDL_SCANCODE_SPACE, SDLK_SPACE), ViewCommandKind::pause);
  EXPECT_EQ(kind_of(SDL_SCANCODE_R, SDLK_r), restart);
  EXPECT_EQ(kind_of(SDL_SCANCODE_S, SDLK_s), save);
  EXPECT_EQ(kind_of(SDL_SCANCODE_C, SDLK_c), copy);
  EXPECT_EQ(kind_of(SDL_SCANCODE_F, SDLK_f), focus);
  EXPECT_EQ(kind_of(SDL_SCANCODE_V, SDLK_v), split);
  EXPECT_EQ(kind_of(SDL_SCANCODE_P, SDLK_p), next_sampler);
  EXPECT_EQ(kind_of(SDL_SCANCODE_ESCAPE, SDLK_ESCAPE), escape);
  EXPECT_EQ(kind_of(SDL_SCANCODE_O, SDLK_o), camera);
  EXPECT_EQ(command_of_key({SDL_SCANCODE_N, SDLK_n}), (ViewCommand{next_scene, 1}));
  EXPECT_EQ(command_of_key({SDL_SCANCODE_N, SDLK_n, true}), (ViewCommand{next_scene, -1}));
  const std::pair<int, Effect> toggles[] = {{'a', Effect::antialiasing}, {'l', Effect::lens},
                                            {'m', Effect::motion},       {'d', Effect::disk_lights},
                                            {'g', Effect::gloss},        {'t', Effect::translucency}};
  for (const auto& [letter, effect] : toggles) {
    EXPECT_EQ(command_of_key({SDL_SCANCODE_UNKNOWN, letter}), (ViewCommand{toggle_effect, 0, false, effect}));
  }
  EXPECT_EQ(command_of_key({SDL_SCANCODE_LEFT, SDLK_LEFT}), (ViewCommand{step_sample, -1}));
  EXPECT_EQ(command_of_text("?").kind, help);
  EXPECT_EQ(command_of_text("+").kind, more_rays);
  EXPECT_EQ(command_of_text("-").kind, fewer_rays);
  EXPECT_EQ(command_of_text("x").kind, none);
}

TEST(InputMap, HeldKeysAndShortcutsOfOthersDoNothing) {
  EXPECT_EQ(command_of_key({SDL_SCANCODE_L, SDLK_l, false, false, true}).kind, none) << "held down";
  EXPECT_EQ(command_of_key({SDL_SCANCODE_RIGHT, SDLK_RIGHT, false, false, true}).kind, step_sample) << "held down";
  EXPECT_EQ(command_of_key({SDL_SCANCODE_C, SDLK_c, false, true}).kind, none) << "Ctrl+C";
}

}  // namespace
}  // namespace penumbra
