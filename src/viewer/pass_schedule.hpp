// How a picture grows: which samples the next pass adds. What is seen after it is the picture that `penumbra render`
// makes with so many rays per pixel, always.
//
// A sequence goes on where it is: 1, 2, 4, ... rays, then by powers of two that take about as long as the eye waits.
// The picture of one ray is a picture of its own (its ray goes through the middle of the pixel), so the second pass
// starts afresh. A pattern that needs the count starts afresh with each pass and draws all its rays: 1, 4, 16, ...
#pragma once

#include <cstdint>
#include <optional>

namespace penumbra {

struct Pass {
  std::uint32_t first = 0, end = 0;  // samples of every pixel; first is 0 where the film starts afresh
  std::uint32_t count = 1;           // what the frame has to be made for

  bool operator==(const Pass&) const = default;
};

struct PassRules {
  bool needs_count = false;       // of the pattern
  std::uint32_t limit = 0;        // rays per pixel, 0: as many as there can be
  std::uint32_t granularity = 1;  // the fewest samples worth a pass, a power of two
};

// The largest set that is made without being asked for.
inline constexpr std::uint32_t most_rays_of_free_set = 1u << 14;
// How long a pass should take, seconds.
inline constexpr double pass_seconds = 0.2;

// The pass after `rays` rays per pixel, of which one more takes `seconds_per_ray` for the whole picture; nothing if the
// picture is done.
std::optional<Pass> next_pass(const PassRules& rules, std::uint32_t rays, double seconds_per_ray);

}  // namespace penumbra
