// As many rays as a pixel needs: more where the picture is uncertain, until the standard error of every pixel is small
// enough. noise_estimate.hpp tells how the error is known, adaptive.cpp where the rays go.
#pragma once

#include <cstdint>

#include "rendering/film.hpp"
#include "rendering/plan.hpp"
#include "rendering/render.hpp"

namespace penumbra {

struct NoiseGoal {
  // The standard error that no pixel shall exceed: the root of the mean of the squares over r, g, b, each clamped to
  // 0..1.
  float error = 0.01f;
  // The most rays a pixel gets; what is not a power of two is rounded down to one.
  std::uint32_t most_rays = 1u << 16;
};

inline constexpr std::uint32_t fewest_adaptive_rays = 4;  // the smallest `most_rays` there is

struct AdaptiveResult {
  RayCounts rays;
  std::uint64_t unfinished_pixels = 0;  // those that got the most rays and would have had more
};

// Fills the film, which must be new and have counts of its own for each pixel. The frame must be made for `most_rays` a
// pixel. The film comes out the same for all threads, kernels and crops. If it was stopped, it is incomplete.
AdaptiveResult render_adaptive(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan,
                               const NoiseGoal& goal, RenderState& state);

}  // namespace penumbra
