// An adaptive render in one go.
#pragma once

#include "rendering/adaptive.hpp"

namespace penumbra::test {

struct AdaptiveResult {
  RayCounts rays;
  std::uint64_t unfinished_pixels = 0;  // that got the maximum of rays but needed more
};

// Fills the film, which must have a sample count for each pixel. If stopped, the film is incomplete.
inline AdaptiveResult render_adaptive(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan,
                                      const NoiseGoal& goal, RenderState& state) {
  AdaptiveRender render(frame, kernel, {film.crop(), film.layers(), plan.threads, plan.shard}, goal);
  const RayCounts rays = render.run(state);
  film = render.take_film();
  return {rays, render.unfinished_pixels()};
}

}  // namespace penumbra::test
