// The mouse over the picture: drag to pan, wheel to zoom, drag the divider of the split view, click to inspect. Where
// it moves the camera: drag to turn, drag with Shift or the right button to move, wheel to come nearer.
#pragma once

#include <SDL.h>

#include <optional>

#include "viewer/session.hpp"

namespace penumbra {

class Mouse {
 public:
  void handle(Session& session, const SDL_Event& event);
  PlaceInWindow cursor() const { return cursor_; }
  // The area where something covers the picture and gets the mouse instead.
  void set_covered(const std::optional<WindowArea>& area) { covered_ = area; }
  // The place of a click on the picture's part of the window that was not a drag; each is returned once.
  std::optional<PlaceInWindow> take_click() { return std::exchange(click_, std::nullopt); }

 private:
  enum class Dragging { nothing, press, picture, divider, turn, move };

  bool is_over_picture(const Session& session, PlaceInWindow place) const;
  void press(const Session& session, std::uint8_t button);
  void move(Session& session, PlaceInWindow to);

  PlaceInWindow cursor_, pressed_;
  Dragging dragging_ = Dragging::nothing;
  bool shift_ = false;       // held when the last event happened; SDL_GetModState() may be ahead of the events
  bool moves_ = false;       // a drag of the camera moves it, rather than turns
  std::uint8_t button_ = 0;  // that is held
  std::optional<PlaceInWindow> click_;
  std::optional<WindowArea> covered_;
};

}  // namespace penumbra
