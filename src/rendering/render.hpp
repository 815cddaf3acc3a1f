// Adds the same samples of all pixels to a film: a picture, or one pass of it.
#pragma once

#include "rendering/film.hpp"
#include "rendering/plan.hpp"
#include "rendering/render_state.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

// Adds the samples of the range to every pixel of the film that the plan's shard has, on `plan.threads` threads; pixels
// that already have some of them get the rest. Returns the rays sent. If stopped, some pixels have fewer samples, and
// the film knows how many.
RayCounts render_samples(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan, SampleRange range,
                         RenderState& state);

}  // namespace penumbra
