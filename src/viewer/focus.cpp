#include "viewer/focus.hpp"

#include <cmath>
#include <limits>

namespace penumbra {

std::optional<double> distance_at(const Frame& frame, const Kernel& kernel, double x, double y) {
  const FrameCamera& camera = frame.camera;
  ProbeRay ray{};
  ray.time = camera.shutter_open;
  ray.farthest = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 3; i++) {
    ray.origin[i] = camera.eye[i];
    ray.direction[i] = static_cast<float>(x * camera.per_x[i] + y * camera.per_y[i] + camera.corner[i]);
  }
  ProbeHit hit{};
  kernel.intersect(frame.world, {&ray, 1}, {&hit, 1});
  if (!std::isfinite(hit.distance)) return std::nullopt;
  double distance = 0;
  for (int i = 0; i < 3; i++) distance += (double{hit.point[i]} - camera.eye[i]) * camera.view[i];
  if (!(distance > 0)) return std::nullopt;
  return distance;
}

}  // namespace penumbra
