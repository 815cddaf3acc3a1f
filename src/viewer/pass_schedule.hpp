// How a picture grows: which samples the next pass adds. After every pass, the window shows exactly the picture that
// `penumbra render` makes with that number of rays per pixel.
//
// A sequence simply continues: 1, 2, 4, ... rays, then in steps of powers of two that take about `pass_seconds`. The
// picture with one ray per pixel is a special case (its ray goes through the middle of the pixel), so the second pass
// starts afresh. A pattern that needs the count starts afresh with each pass and draws all its rays: 1, 4, 16, ...
#pragma once

#include <cstdint>
#include <optional>

namespace penumbra {

struct Pass {
  std::uint32_t first = 0, end = 0;  // samples of every pixel; first is 0 if the film starts afresh
  std::uint32_t count = 1;           // the number of samples that the frame is made for

  bool operator==(const Pass&) const = default;
};

struct PassRules {
  bool needs_count = false;       // of the pattern
  std::uint32_t limit = 1;        // rays per pixel
  std::uint32_t granularity = 1;  // the fewest samples worth a pass, a power of two
};

// How long a pass should take, seconds.
inline constexpr double pass_seconds = 0.2;

// The pass that follows `rays` rays per pixel, if one more ray in every pixel takes `seconds_per_ray`; nothing if the
// picture is done.
std::optional<Pass> next_pass(const PassRules& rules, std::uint32_t rays, double seconds_per_ray);

}  // namespace penumbra
