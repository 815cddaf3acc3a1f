// The same samples of all pixels, added to a film: a picture, or a pass of one.
#pragma once

#include "rendering/film.hpp"
#include "rendering/plan.hpp"
#include "rendering/render_state.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

// Adds the samples of the range to every pixel of the film that the plan's shard has, by `plan.threads` threads; pixels
// that have some of them already get the rest. Returns the rays sent. If it was stopped, some pixels have fewer
// samples, and the film says how many.
RayCounts render_samples(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan, SampleRange range,
                         RenderState& state);

}  // namespace penumbra
