// Scenes that are looked at along one ray, and an environment that tells where rays go: the inside of a huge ball whose
// colour is its normal.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "rendering/render_text.hpp"

namespace penumbra::test {

inline std::string numbers(Vec3 v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z); }

// A picture of one pixel, so narrow that all its rays are one.
inline std::string look(Vec3 eye, Vec3 direction) {
  const Vec3 w = -normalize(direction);
  const Vec3 u = normalize(std::abs(w.y) < 0.9 ? cross({0, 1, 0}, w) : cross({1, 0, 0}, w));
  return fmt::format("image_size 1 1\nfov 0.0001\neye {}\nuvw {} {} {}\n", numbers(eye), numbers(u),
                     numbers(cross(w, u)), numbers(w));
}

inline Vec3 color_of(const std::string& text, const RenderSettings& settings = {}) {
  return render_text(text, settings).at(0, 0);
}

inline constexpr double environment_radius = 1000;

// The ball and its lights: a ray that ends on it at the outward normal n sees (sx n.x, sy n.y, sz n.z), each clamped at
// zero. Needs RenderSettings::shadows = false: the lights are outside.
inline std::string environment(Vec3 signs) {
  return fmt::format("light {} 0 0 1 0 0\nlight 0 {} 0 0 1 0\nlight 0 0 {} 0 0 1\nsurface 1 1 1\nsphere {} 0 0 0\n",
                     signs.x * 1e7, signs.y * 1e7, signs.z * 1e7, environment_radius);
}

inline RenderSettings without_shadows() {
  RenderSettings settings;
  settings.shadows = false;
  return settings;
}

// Where a ray from `origin` along the unit vector d leaves the environment's ball: its normal there.
inline Vec3 seen_normal(Vec3 origin, Vec3 d) {
  const double b = dot(origin, d);
  const double t = -b + std::sqrt(b * b - dot(origin, origin) + environment_radius * environment_radius);
  return (origin + d * t) / environment_radius;
}

inline void expect_color(Vec3 color, Vec3 expected, double tolerance) {
  EXPECT_NEAR(color.x, expected.x, tolerance);
  EXPECT_NEAR(color.y, expected.y, tolerance);
  EXPECT_NEAR(color.z, expected.z, tolerance);
}

}  // namespace penumbra::test
