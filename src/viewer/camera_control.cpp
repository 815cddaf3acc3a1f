#include "viewer/camera_control.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture/plain_number.hpp"

namespace penumbra {
namespace {

constexpr double degrees_per_picture = 180;  // of a drag across the whole picture
constexpr double steepest = 87;              // degrees above or below the horizon
constexpr int axis_decimals = 5;             // a fiftieth of a pixel or less
constexpr double needed_precision = 1e-4;    // of the eye, as a share of the distance

Vec3 vec(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

// The axis of the world that is nearest to `up`.
Vec3 nearest_axis(Vec3 up) {
  int axis = 1;
  for (const int other : {0, 2}) {
    if (std::abs(up[other]) > std::abs(up[axis])) axis = other;
  }
  Vec3 vertical;
  vertical[axis] = up[axis] < 0 ? -1 : 1;
  return vertical;
}

Vec3 rounded(Vec3 v, int decimals) {
  return {with_decimals(v.x, decimals), with_decimals(v.y, decimals), with_decimals(v.z, decimals)};
}

// Where there is nothing to hold: a point as far away as what is in the middle of the picture, or in focus.
double distance_in_the_air(const Camera& camera, const Frame& frame, const Kernel& kernel) {
  if (const auto middle = distance_at(frame, kernel, frame.settings.width / 2.0, frame.settings.height / 2.0)) {
    return *middle;
  }
  return camera.lens_radius > 0 ? camera.focus_distance : std::max(length(camera.eye), 1.0);
}

}  // namespace

CameraPose pose_of(const Camera& camera) { return {camera.eye, {camera.right, camera.up, camera.back}}; }

CameraPose as_written(const CameraPose& pose, double distance) {
  const double digits = -std::floor(std::log10(std::max(distance, 1e-12) * needed_precision));
  const int decimals = std::clamp(static_cast<int>(digits), 0, 16);
  const CameraAxes& axes = pose.axes;
  return {rounded(pose.eye, decimals),
          {rounded(axes.right, axis_decimals), rounded(axes.up, axis_decimals), rounded(axes.back, axis_decimals)}};
}

CameraGrip grip_at(const Camera& camera, Vec3 up, const Frame& frame, const Kernel& kernel, PlaceInPicture place) {
  const FrameCamera& seen = frame.camera;
  const Vec3 ray = place.x * vec(seen.per_x) + place.y * vec(seen.per_y) + vec(seen.corner);
  const Vec3 eye = frame.origin + vec(seen.eye);
  std::optional<Vec3> point = point_at(frame, kernel, place.x, place.y);
  if (!point) point = eye + ray * (distance_in_the_air(camera, frame, kernel) / dot(ray, vec(seen.view)));
  const double times = dot(*point - eye, vec(seen.view)) / dot(ray, vec(seen.view));
  CameraGrip grip;
  grip.pose = pose_of(camera);
  grip.point = *point;
  grip.per_x = vec(seen.per_x) * times;
  grip.per_y = vec(seen.per_y) * times;
  grip.vertical = nearest_axis(up);
  grip.degrees = degrees_per_picture / std::min(frame.settings.width, frame.settings.height);
  return grip;
}

CameraPose turned(const CameraGrip& grip, double pixels_right, double pixels_down) {
  const CameraAxes& axes = grip.pose.axes;
  const double sine = std::clamp(dot(normalize(axes.back), grip.vertical), -1.0, 1.0);
  const double elevation = std::asin(sine) * 180 / std::numbers::pi;
  const double limit = std::max(steepest, std::abs(elevation));
  const double rise = std::clamp(elevation + pixels_down * grip.degrees, -limit, limit) - elevation;
  const Affine turn =
      rotation(-pixels_right * grip.degrees, grip.vertical) * rotation(-rise, cross(axes.up, axes.back));
  const auto about = [&turn](Vec3 v) { return transform_vector(turn, v); };
  return {grip.point + about(grip.pose.eye - grip.point), {about(axes.right), about(axes.up), about(axes.back)}};
}

CameraPose moved(const CameraGrip& grip, double pixels_right, double pixels_down) {
  CameraPose pose = grip.pose;
  pose.eye = pose.eye - (pixels_right * grip.per_x + pixels_down * grip.per_y);
  return pose;
}

CameraPose nearer(const CameraGrip& grip, double steps) {
  CameraPose pose = grip.pose;
  pose.eye = grip.point + (pose.eye - grip.point) * std::pow(0.9, steps);
  return pose;
}

}  // namespace penumbra
