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

void Mouse::press(const Session& session, std::uint8_t button) {
  const bool is_right = button == SDL_BUTTON_RIGHT;
  if (button != SDL_BUTTON_LEFT && !(is_right && session.moves_camera())) return;
  if (dragging_ != Dragging::nothing || !is_over_picture(session, cursor_)) return;
  button_ = button;
  pressed_ = cursor_;
  const bool at_divider = session.split() && std::abs(cursor_.x - divider_in_window(session)) <= divider_reach;
  dragging_ = at_divider ? Dragging::divider : Dragging::press;
  moves_ = is_right || shift_;
}

void Mouse::move(Session& session, PlaceInWindow to) {
  const bool far = std::abs(to.x - pressed_.x) > click_reach || std::abs(to.y - pressed_.y) > click_reach;
  if (dragging_ == Dragging::press && far) {
    dragging_ = !session.moves_camera() ? Dragging::picture : moves_ ? Dragging::move : Dragging::turn;
    cursor_ = pressed_;
    if (session.moves_camera()) session.take_hold(pressed_);
  }
  if (dragging_ == Dragging::turn) session.turn_camera(to.x - pressed_.x, to.y - pressed_.y);
  if (dragging_ == Dragging::move) session.move_camera(to.x - pressed_.x, to.y - pressed_.y);
  if (dragging_ == Dragging::picture) session.view().pan(to.x - cursor_.x, to.y - cursor_.y);
  if (dragging_ == Dragging::divider) {
    const WindowArea picture = session.view().picture();
    session.set_divider((to.x - picture.x) / std::max(picture.width, 1));
  }
  cursor_ = to;
}

void Mouse::handle(Session& session, const SDL_Event& event) {
  switch (event.type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      shift_ = (event.key.keysym.mod & KMOD_SHIFT) != 0;
      break;
    case SDL_MOUSEMOTION:
      move(session, place_of(event.motion.x, event.motion.y));
      break;
    case SDL_MOUSEBUTTONDOWN:
      move(session, place_of(event.button.x, event.button.y));
      press(session, event.button.button);
      break;
    case SDL_MOUSEBUTTONUP:
      move(session, place_of(event.button.x, event.button.y));
      if (event.button.button != button_) break;
      if (dragging_ == Dragging::press && button_ == SDL_BUTTON_LEFT) click_ = cursor_;
      dragging_ = Dragging::nothing;
      break;
    case SDL_MOUSEWHEEL:
      if (!is_over_picture(session, cursor_)) break;
      if (session.moves_camera()) {
        session.bring_camera_nearer(event.wheel.y, cursor_);
      } else {
        session.view().zoom(event.wheel.y, cursor_);
      }
      break;
    default:
      break;
  }
}

}  // namespace penumbra
