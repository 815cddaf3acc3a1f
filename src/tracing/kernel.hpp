// The door between code for any machine and code for one instruction set: a table of plain functions, one for each set
// of lanes that was compiled. Nothing else of the compiled packets is visible outside.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "tracing/film_view.hpp"
#include "tracing/frame.hpp"
#include "tracing/probe.hpp"
#include "tracing/ray_kind.hpp"
#include "tracing/recorded_ray.hpp"

namespace penumbra {

struct Kernel {
  const char* isa;  // sse42, avx2, avx512
  int lanes;
  // Adds the samples to the film and the rays to the counts. Allocates nothing.
  void (*render_pixels)(const Frame&, const FilmView&, const PixelSamples&, RayCounts&);
  // Traces one sample of a pixel, as render_pixels does for a picture of `count` samples, and tells all its rays.
  // Returns its colour.
  std::array<float, 3> (*record_sample)(const Frame&, int x, int y, std::uint32_t sample, std::uint32_t count,
                                        const RayListener&);
  // What each ray hits first, by the same packets as in a picture.
  void (*intersect)(const World&, std::span<const ProbeRay>, std::span<ProbeHit>);
  // The first u.size() sample points of a pixel: its places in the pixel (pixel_x), on the lens
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
