#include "viewer/projection.hpp"

#include <cmath>
#include <limits>

#include "base/vec.hpp"

namespace penumbra {
namespace {

Vec3 vec(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

// t, t x and t y of P - eye = t (x per_x + y per_y + corner).
struct Homogeneous {
  double tx, ty, t;
};

class Projection {
 public:
  explicit Projection(const FrameCamera& camera)
      : eye_(vec(camera.eye)), x_(vec(camera.per_x)), y_(vec(camera.per_y)), corner_(vec(camera.corner)) {
    volume_ = dot(cross(x_, y_), corner_);
  }

  Homogeneous operator()(const float (&point)[3]) const {
    const Vec3 d = vec(point) - eye_;
    return {dot(cross(d, y_), corner_) / volume_, dot(cross(x_, d), corner_) / volume_,
            dot(cross(x_, y_), d) / volume_};
  }

 private:
  Vec3 eye_, x_, y_, corner_;
  double volume_;
};

Homogeneous between(const Homogeneous& a, const Homogeneous& b, double share) {
  const auto mix = [share](double p, double q) { return p + (q - p) * share; };
  return {mix(a.tx, b.tx), mix(a.ty, b.ty), mix(a.t, b.t)};
}

}  // namespace

std::optional<std::pair<PlaceInPicture, PlaceInPicture>> project_line(const FrameCamera& camera, const float (&from)[3],
                                                                      const float (&to)[3]) {
  const Projection project(camera);
  Homogeneous a = project(from);
  Homogeneous b = project(to);
  const double nearest = 1e-3 * std::max(a.t, b.t);
  if (!(nearest > 0)) return std::nullopt;
  if (a.t < nearest) a = between(a, b, (nearest - a.t) / (b.t - a.t));
  if (b.t < nearest) b = between(b, a, (nearest - b.t) / (a.t - b.t));
  return {{{a.tx / a.t, a.ty / a.t}, {b.tx / b.t, b.ty / b.t}}};
}

std::optional<Vec3> point_at(const Frame& frame, const Kernel& kernel, double x, double y) {
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
  return vec(hit.point) + frame.origin;
}

std::optional<double> distance_at(const Frame& frame, const Kernel& kernel, double x, double y) {
  const std::optional<Vec3> point = point_at(frame, kernel, x, y);
  if (!point) return std::nullopt;
  const double distance = dot(*point - frame.origin - vec(frame.camera.eye), vec(frame.camera.view));
  if (!(distance > 0)) return std::nullopt;
  return distance;
}

}  // namespace penumbra
