#include "base/vec.hpp"

#include <numbers>

namespace penumbra {

Affine rotation(double degrees, Vec3 axis) {
  const Vec3 k = normalize(axis);
  const double angle = degrees * std::numbers::pi / 180;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  const auto rotate = [&](Vec3 v) { return v * c + cross(k, v) * s + k * (dot(k, v) * (1 - c)); };
  return {{rotate({1, 0, 0}), rotate({0, 1, 0}), rotate({0, 0, 1})}, {}};
}

}  // namespace penumbra
