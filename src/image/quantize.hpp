// Maps a colour to the integer that a file stores: the nearest one, or the one that the course's own programs write.
// All steps but the last are exact in double precision, so the result depends on the float alone. No gamma.
#pragma once

#include <cstdint>

namespace penumbra {

enum class Rounding {
  nearest,  // floor(max * v + 0.5)
  course    // floor(max * v + 1e-4): 0.3 gives 76 of 255, and 0.2 gives 51, as does the next float below it
};

// The number in 0..max for a colour v, which is clamped to 0..1; NaN gives 0.
inline std::int32_t quantize(float v, std::int32_t max, Rounding rounding) {
  const float clamped = v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f;
  return static_cast<std::int32_t>(static_cast<double>(max) * clamped + (rounding == Rounding::course ? 1e-4 : 0.5));
}

inline std::uint8_t quantize_8(float v, Rounding rounding = Rounding::nearest) {
  return static_cast<std::uint8_t>(quantize(v, 255, rounding));
}

inline std::uint16_t quantize_16(float v, Rounding rounding = Rounding::nearest) {
  return static_cast<std::uint16_t>(quantize(v, 65535, rounding));
}

}  // namespace penumbra
