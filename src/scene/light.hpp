// The lights of a scene: plain data in double precision. None weakens with distance, and none is seen itself.
#pragma once

#include <string_view>
#include <variant>

#include "base/vec.hpp"

namespace penumbra {

using Color = Vec3;  // r, g, b; linear; 1 is the full output value, never clamped before the output

struct PointLight {
  static constexpr std::string_view name = "point light";
  Vec3 position;
  Color color;
};

// Each shadow ray goes to its own point, uniform over the disk's area; no cosine, both sides shine.
struct DiskLight {
  static constexpr std::string_view name = "disk light";
  Vec3 center;
  double radius = 0;
  Vec3 direction{0, -1, 0};  // normal of the disk, any length but zero
  Color color;
};

// Full inside `inner_degrees` from the axis, none beyond `outer_degrees`, smoothstep between the cosines.
struct SpotLight {
  static constexpr std::string_view name = "spotlight";
  Vec3 position;
  Vec3 direction{0, 0, -1};  // the axis, any length but zero
  double inner_degrees = 0;
  double outer_degrees = 0;
  Color color;
};

using Light = std::variant<PointLight, DiskLight, SpotLight>;

// The light whose centre alone shines.
inline Light without_area(const PointLight& light) { return light; }
inline Light without_area(const DiskLight& l) { return DiskLight{l.center, 0, l.direction, l.color}; }
inline Light without_area(const SpotLight& light) { return light; }

}  // namespace penumbra
