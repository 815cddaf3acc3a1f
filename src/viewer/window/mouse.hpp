// The mouse over the picture: drag to pan, wheel to zoom, drag the divider of the split view, click to inspect.
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
  enum class Dragging { nothing, press, picture, divider };

  bool is_over_picture(const Session& session, PlaceInWindow place) const;
  void press(const Session& session);
  void move(Session& session, PlaceInWindow to);

  PlaceInWindow cursor_, pressed_;
  Dragging dragging_ = Dragging::nothing;
  std::optional<PlaceInWindow> click_;
  std::optional<WindowArea> covered_;
};

}  // namespace penumbra
