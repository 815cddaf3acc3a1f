#include "viewer/pass_schedule.hpp"

#include <algorithm>

#include "scene/settings.hpp"

namespace penumbra {
namespace {

// The largest power of two that divides n and takes no longer than a pass should.
std::uint32_t step_after(std::uint32_t n, std::uint32_t granularity, double seconds_per_ray) {
  std::uint32_t step = n & -n;
  while (step > granularity && step * seconds_per_ray > pass_seconds) step /= 2;
  return step;
}

}  // namespace

std::optional<Pass> next_pass(const PassRules& rules, std::uint32_t rays, double seconds_per_ray) {
  const std::uint32_t limit = std::min(rules.limit, std::uint32_t{most_rays_per_pixel});
  if (rays >= limit) return std::nullopt;
  if (rays == 0) return Pass{0, 1, 1};
  if (rules.needs_count) {
    const std::uint32_t count = std::min(4 * rays, limit);
    return Pass{0, count, count};
  }
  if (rays == 1) return Pass{0, 2, limit};
  return Pass{rays, std::min(rays + step_after(rays, rules.granularity, seconds_per_ray), limit), limit};
}

}  // namespace penumbra
