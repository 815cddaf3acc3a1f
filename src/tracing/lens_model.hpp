// The two ways in which the lecture simulates a lens (slides 49 and 50).
#pragma once

#include <cstdint>
#include <string_view>

namespace penumbra {

enum class LensModel : std::uint8_t {
  thin,  // approach 2: from a point of the lens through the point in focus
  cone   // approach 1: from the eye, within the cone of radius r at the distance of what the pinhole would see
};

inline constexpr std::string_view lens_model_names[] = {"thin", "cone"};

}  // namespace penumbra
