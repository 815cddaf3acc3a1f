// Statistics of a render: the JSON of `--stats`.
#pragma once

#include <optional>
#include <string>

#include "rendering/uniform_render.hpp"

namespace penumbra {

struct RenderStats {
  double parse_seconds = 0, build_seconds = 0, render_seconds = 0, write_seconds = 0;
  double render_cpu_seconds = 0;  // of all threads
  RayCounts rays;
  std::uint64_t samples = 0;  // of all pixels: camera rays
  int threads = 0;
  int lanes = 0;
  std::string isa;
  Settings settings;
  std::optional<double> noise;  // if the render was adaptive
  std::uint64_t shapes = 0, triangles = 0, instances = 0, lights = 0;
};

// For several pictures, times, rays and samples are summed; the rest is that of the last picture.
std::string to_json(const RenderStats& stats);

}  // namespace penumbra
