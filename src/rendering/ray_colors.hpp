// One colour for each kind of ray, for all that draw them: the window, and the model in scenes/lecture/ray_tree.cli.
// The pages of docs/ call them by these words.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tracing/ray_kind.hpp"
#include "tracing/recorded_ray.hpp"

namespace penumbra {

struct RayColor {
  std::string_view word;
  std::array<std::uint8_t, 3> rgb;  // as in a PNG
};

inline constexpr RayColor ray_colors[ray_kind_count] = {
    {"black", {31, 31, 36}}, {"amber", {242, 166, 13}}, {"red", {217, 46, 31}}, {"blue", {31, 97, 217}}};
inline constexpr RayColor color_of_blocked_ray = {"grey", {140, 140, 140}};

inline const RayColor& color_of(const RecordedRay& ray) {
  const bool is_blocked = ray.kind == RayKind::shadow && ray.hit;
  return is_blocked ? color_of_blocked_ray : ray_colors[static_cast<std::size_t>(ray.kind)];
}

}  // namespace penumbra
