// The door between code for any machine and code for one instruction set: a table of plain functions, one for each set
// of lanes that was compiled. Nothing else of the compiled packets is visible outside.
#pragma once

#include <cstdint>
#include <span>

#include "tracing/film_view.hpp"
#include "tracing/frame.hpp"

namespace penumbra {

// `camera`: one for each sample, whatever the lens model needs to aim it.
struct RayCounts {
  std::uint64_t camera = 0, shadow = 0, reflection = 0, transmission = 0;

  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    shadow += other.shadow;
    reflection += other.reflection;
    transmission += other.transmission;
    return *this;
  }
  std::uint64_t total() const { return camera + shadow + reflection + transmission; }
};

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

enum class RayKind : std::uint8_t { eye, reflection, transmission, shadow };

// One ray of a sample, as it was traced.
struct RecordedRay {
  RayKind kind;
  int depth;            // 0 for the eye ray
  int parent;           // the ray whose hit sent it, by its number in the order of the records; -1 for the eye ray
  std::uint32_t count;  // one of so many rays of its kind, whose mean counts
  float origin[3], direction[3];  // the direction has length one
  float time;
  bool hit;        // whether it hit anything; of a shadow ray, whether anything is in the way
  float distance;  // to what was hit
  std::uint32_t surface;
  float point[3], normal[3];  // in the world; the normal is the one that shades
  float ambient[3];           // what the surface shines by itself
  std::uint32_t light;        // of a shadow ray
  float light_distance;       // to the point of the light
  float came_back[3];         // the colour the ray saw; of a shadow ray, the share of the light that comes through
  float factor[3];  // what that is worth where the ray was sent from; of a shadow ray known only if light came back
  float adds[3];    // of a shadow ray: what it adds there
};

// Who wants to know all rays of a sample.
struct RayListener {
  void* self;
  // Returns where to keep a new ray, in the order in which the rays are sent, or null if there is no more room. What
  // comes back is filled in later, so what was returned must stay where it is.
  RecordedRay* (*add)(void* self);
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
