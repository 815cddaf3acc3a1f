#include "viewer/window/mouse.hpp"

#include <imgui.h>

#include <cmath>

#include "viewer/window/picture_layer.hpp"

namespace penumbra {
namespace {

constexpr double click_reach = 3;    // pixels that the mouse may move during a click
constexpr double divider_reach = 6;  // pixels from the divider within which it can be grabbed

bool is_in(const WindowArea& area, PlaceInWindow place) {
  return place.x >= area.x && place.y >= area.y && place.x < area.x + area.width && place.y < area.y + area.height;
}

PlaceInWindow place_of(int x, int y) { return {static_cast<double>(x), static_cast<double>(y)}; }

}  // namespace

bool Mouse::is_over_picture(const Session& session, PlaceInWindow place) const {
  if (!is_in(session.view().area(), place) || (covered_ && is_in(*covered_, place))) return false;
  return !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void Mouse::press(const Session& session) {
  if (!is_over_picture(session, cursor_)) return;
  pressed_ = cursor_;
  const bool at_divider = session.split() && std::abs(cursor_.x - divider_in_window(session)) <= divider_reach;
  dragging_ = at_divider ? Dragging::divider : Dragging::press;
}

void Mouse::move(Session& session, PlaceInWindow to) {
  const bool far = std::abs(to.x - pressed_.x) > click_reach || std::abs(to.y - pressed_.y) > click_reach;
  if (dragging_ == Dragging::press && far) {
    dragging_ = Dragging::picture;
    cursor_ = pressed_;
  }
  if (dragging_ == Dragging::picture) session.view().pan(to.x - cursor_.x, to.y - cursor_.y);
  if (dragging_ == Dragging::divider) {
    const WindowArea picture = session.view().picture();
    session.set_divider((to.x - picture.x) / std::max(picture.width, 1));
  }
  cursor_ = to;
}

void Mouse::handle(Session& session, const SDL_Event& event) {
  switch (event.type) {
    case SDL_MOUSEMOTION:
      move(session, place_of(event.motion.x, event.motion.y));
      break;
    case SDL_MOUSEBUTTONDOWN:
      move(session, place_of(event.button.x, event.button.y));
      if (event.button.button == SDL_BUTTON_LEFT) press(session);
      break;
    case SDL_MOUSEBUTTONUP:
      move(session, place_of(event.button.x, event.button.y));
      if (event.button.button != SDL_BUTTON_LEFT) break;
      if (dragging_ == Dragging::press) click_ = cursor_;
      dragging_ = Dragging::nothing;
      break;
    case SDL_MOUSEWHEEL:
      if (is_over_picture(session, cursor_)) session.view().zoom(event.wheel.y, cursor_);
      break;
    default:
      break;
  }
}

}  // namespace penumbra
