// The one loop of the program: everything that renders, calls this.
#pragma once

#include <atomic>
#include <cstdint>

#include "rendering/film.hpp"
#include "rendering/plan.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

// Shared with whoever watches or stops a render.
struct RenderState {
  std::atomic<std::uint64_t> pixel_samples_done{0};      // pixels times samples
  std::atomic<std::uint64_t> pixel_samples_before{0};    // of these, in earlier sittings
  std::atomic<std::uint64_t> pixel_samples_expected{0};  // in all; 0: whoever renders does not know better
  std::atomic<std::uint64_t> rays{0};
  std::atomic<bool> stop{false};  // ends the render in some hundredths of a second; calling it again goes on
};

// Adds the samples of the range to every pixel of the film that the plan's shard has, by `plan.threads` threads; pixels
// that have some of them already get the rest. Returns the rays sent. If it was stopped, some pixels have fewer
// samples, and the film says how many.
RayCounts render_samples(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan, SampleRange range,
                         RenderState& state);

// How many threads to use when none are asked for: what Slurm gives the task, else the processors this process may use.
int default_thread_count();

}  // namespace penumbra
