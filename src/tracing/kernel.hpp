// The door between code for any machine and code for one instruction set: a table of plain functions, one for each set
// of lanes that was compiled. Nothing else of the compiled packets is visible outside.
#pragma once

#include <cstdint>
#include <span>

#include "tracing/film_view.hpp"
#include "tracing/frame.hpp"
#include "tracing/ray_kind.hpp"
#include "tracing/recorded_ray.hpp"

namespace penumbra {

struct ProbeRay {
  float origin[3], direction[3];  // direction of any length
  float time, farthest;
};
struct ProbeHit {
  float distance;  // infinity where nothing is nearer than `farthest`
  std::uint32_t surface;
  float normal[3], point[3];
};

enum class LaneFunction {
  sine,
  cosine,
  log2,
  exp2,
  power,
  whole_power,   // a to the whole power b
  common_power,  // the same with one power for all lanes: that of the first
  acos_turns,
  disk_x,
  disk_y,
  ball_x,
  ball_y,
  ball_z,
  noise,
  // Textures of the point (a, b, c), channel by channel, and the border of a stone as StoneCell has it.
  wood_red,
  wood_green,
  wood_blue,
  marble,
  stone_red,
  stone_green,
  stone_blue,
  stone_border
};

struct Kernel {
  const char* isa;  // sse42, avx2, avx512
  int lanes;
  // Adds the samples to the film and the rays to the counts. Allocates nothing.
  void (*render_pixels)(const Frame&, const FilmView&, const PixelSamples&, RayCounts&);
  // Traces one sample of a pixel, as render_pixels does for a picture of `count` samples, and tells all its rays.
  void (*record_sample)(const Frame&, int x, int y, std::uint32_t sample, std::uint32_t count, const RayListener&);
  // The two questions of the world, for tests and tools: the same packets as in a picture, ray by ray.
  void (*intersect)(const World&, std::span<const ProbeRay>, std::span<ProbeHit>);
  void (*occluded)(const World&, std::span<const ProbeRay>, std::span<bool>);
  // Elementary functions and warps as the packets compute them, for tests: out[i] = function(a[i], b[i], c[i]).
  void (*evaluate)(LaneFunction function, std::span<const float> a, std::span<const float> b, std::span<const float> c,
                   std::span<float> out);
  // The first u.size() sample points of a pixel, for tests and tools: its places in the pixel (pixel_x), on the lens
  // (lens_radius), on the first light (first_light_radius), in time (shutter_time; v is 0), or in the two later
  // dimensions of that name.
  void (*sample_points)(const Frame&, int x, int y, std::uint32_t dimension, std::span<float> u, std::span<float> v);
};

namespace lanes4 {
extern const Kernel kernel;
}
namespace lanes8 {
extern const Kernel kernel;
}
namespace lanes16 {
extern const Kernel kernel;
}

}  // namespace penumbra
