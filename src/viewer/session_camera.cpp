// How the mouse moves the camera of a session.
#include "viewer/session.hpp"

#include <utility>

#include "picture/scene_lines.hpp"

namespace penumbra {
// While the mouse moves, the next place of the camera waits until there is a picture of the last one, but no longer
// than this.
constexpr std::chrono::milliseconds longest_wait(500);
constexpr double farthest_eye = 1e9;  // from the origin

void Session::take_hold(PlaceInWindow place) {
  grip_.reset();
  if (!picture_ || !loaded_) return;
  const auto pixel = view_.pixel_at(place);
  const int side = pixel ? side_of(*pixel) : 0;
  const Frame& frame = *picture_->sides[static_cast<std::size_t>(side)].frame;
  if (wanted_pose_) show_pose(*std::exchange(wanted_pose_, std::nullopt));
  const PlaceInWindow corner = view_.in_window(0, 0);
  const PlaceInPicture held = {(place.x - corner.x) / view_.zoom_factor(), (place.y - corner.y) / view_.zoom_factor()};
  grip_ = grip_at(changed_scene(0).camera, loaded_->scene->camera.up, frame, *kernel_, held);
  held_at_ = place;
  steps_nearer_ = 0;
}

void Session::want(const CameraPose& pose) {
  if (!(max_component(abs(pose.eye)) < farthest_eye)) return;
  wanted_pose_ = as_written(pose, grip_->distance());
  if (pose.axes == grip_->pose.axes) wanted_pose_->axes = pose.axes;
}

void Session::turn_camera(double right, double down) {
  if (grip_) want(turned(*grip_, right / view_.zoom_factor(), down / view_.zoom_factor()));
}

void Session::move_camera(double right, double down) {
  if (grip_) want(moved(*grip_, right / view_.zoom_factor(), down / view_.zoom_factor()));
}

void Session::bring_camera_nearer(int steps, PlaceInWindow place) {
  if (!grip_ || steps_nearer_ == 0 || place.x != held_at_.x || place.y != held_at_.y) take_hold(place);
  steps_nearer_ += steps;
  if (grip_) want(nearer(*grip_, steps_nearer_));
}

void Session::apply_pose(Clock::time_point now) {
  if (!wanted_pose_ || (!picture_is_current() && now < posed_at_ + longest_wait)) return;
  posed_at_ = now;
  show_pose(*std::exchange(wanted_pose_, std::nullopt));
}

std::string Session::camera_lines() const {
  if (!loaded_) return {};
  const Scene now = changed_scene(0);
  return eye_lines(*loaded_->scene, now) + uvw_lines(*loaded_->scene, now);
}

void Session::show_pose(const CameraPose& pose) {
  const bool is_turned = pose.axes != pose_of(loaded_->scene->camera).axes;
  change([&](PictureOptions& options) {
    options.eye = pose.eye;
    options.uvw = is_turned ? std::optional(pose.axes) : std::nullopt;
  });
}

}  // namespace penumbra
