// The lights of a scene: plain data in double precision. Their light does not fall off with distance, and they are not
// visible themselves.
#pragma once

#include <string_view>
#include <variant>

#include "base/vec.hpp"

namespace penumbra {

using Color = Vec3;  // linear r, g, b; 1 is full output; never clamped before the output

struct PointLight {
  static constexpr std::string_view name = "point light";
  Vec3 position;
  Color color;
};

// Each shadow ray goes to its own point, uniform over the disk's area. Both sides emit, without a cosine.
struct DiskLight {
  static constexpr std::string_view name = "disk light";
  Vec3 center;
  double radius = 0;
  Vec3 direction{0, -1, 0};  // normal of the disk, of any nonzero length
  Color color;
};

// The same for a parallelogram: center + s u + t v with s and t from -1 to 1.
struct QuadLight {
  static constexpr std::string_view name = "quad light";
  Vec3 center;
  Vec3 u, v;  // half edges that do not lie on one line
  Color color;
};

// Full within `inner_degrees` of the axis, none beyond `outer_degrees`; between them, a smoothstep of the cosine.
struct SpotLight {
  static constexpr std::string_view name = "spotlight";
  Vec3 position;
  Vec3 direction{0, 0, -1};  // the axis, of any nonzero length
  double inner_degrees = 0;
  double outer_degrees = 0;
  Color color;
};

using Light = std::variant<PointLight, DiskLight, QuadLight, SpotLight>;

// Whether shadow rays go to different points of it.
inline bool has_area(const Light& light) {
  if (const auto* disk = std::get_if<DiskLight>(&light)) return disk->radius > 0;
  return std::holds_alternative<QuadLight>(light);
}

// The same light, shining from its centre only.
inline Light without_area(const PointLight& light) { return light; }
inline Light without_area(const DiskLight& l) { return DiskLight{l.center, 0, l.direction, l.color}; }
inline Light without_area(const QuadLight& l) { return PointLight{l.center, l.color}; }
inline Light without_area(const SpotLight& light) { return light; }

}  // namespace penumbra
