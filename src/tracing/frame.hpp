// Everything a ray needs to know besides the geometry: camera, lights, surfaces, patterns and limits of one picture, in
// single precision. Made once from scene and options, read by all threads.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/world.hpp"
#include "sampling/sample_tables.hpp"
#include "scene/scene.hpp"
#include "tracing/light_clusters.hpp"

namespace penumbra {

// Direction of the ray through (x, y) in pixels from the top left: x * per_x + y * per_y + corner, not normalised.
struct FrameCamera {
  float eye[3];
  float per_x[3], per_y[3], corner[3];
  float lens_u[3], lens_v[3];  // from the eye to the rim of the lens; zero for a pinhole
  float view[3];               // unit vector along -w
  float focus_distance;
  bool has_lens;
  float shutter_open, shutter_length;
  // Where in the pixel a ray goes: u * pixel_width + pixel_offset from its left and top.
  float pixel_width, pixel_offset;
};

struct FrameSurface {
  float diffuse[3], ambient[3], specular[3];
  float specular_power;
  std::uint32_t whole_power;  // the same where it is a whole number that is not large, else 0
  float reflection, gloss_radius;
  float transmission, refraction_index, blur_radius;
  Texture texture;
  float texture_scale;  // of noise
  bool blinn;
};

inline constexpr int quantum_bits = 28;
inline constexpr float largest_finite_sample = 3e38f;  // a sample beyond it counts as not finite

struct Frame {
  World world;
  Vec3 origin;  // of the space that rays are traced in, in the world of the scene
  FrameCamera camera;
  float background[3];
  std::vector<FrameLight> lights;
  std::vector<FrameSurface> surfaces;
  Settings settings;
  PixelFilter filter = PixelFilter::box;
  FilterSteps filter_steps;       // not of the box
  int light_rays = 0;             // that each hit sends to lights that it chooses; 0: to all lights
  LightClusters light_clusters;   // where it is not 0
  bool chooses_branches = false;  // of the rays that a hit sends (tracing/branching.hpp)
  SampleTables tables;
  // Powers of two, 2^-quantum_bits of the largest sample: samples are rounded to whole multiples of these before they
  // are summed.
  double color_quantum = 0, depth_quantum = 0;
  float largest_color = 0;  // of a sample; what is not finite counts as this

  PatternChoice pattern_choice() const {
    return {settings.pattern, static_cast<std::uint32_t>(settings.rays_per_pixel), settings.seed, &tables};
  }
};

// Both rays of a hit are traced if the geometric mean of what they are worth is at least this.
inline constexpr float least_worth_of_two = 1.0f / 8;

// Whether the picture chooses branches: where a surface sends two rays, and other samples of a pixel average what the
// choice leaves out. The pictures of the course have whole trees.
bool chooses_branches(const Scene& scene);

// Whether rays of the pixels go further than the pixels themselves.
bool filters(const Scene& scene);

// How many shadow rays each hit sends to lights that it chooses; 0: to all lights.
int chosen_light_rays(const Scene& scene);

// The origin of the space that rays are traced in. Single precision is finest round zero: a scene that is seen from far
// out is traced relative to its eye. Whole numbers keep round coordinates exact.
Vec3 origin_for(Vec3 eye);

// Compiles the scene; the world is built for the scene's shutter. Throws std::runtime_error where build_world does.
Frame make_frame(const Scene& scene, int threads);

// The same with a world that was built for a scene of the same objects, the same shutter and the same origin.
Frame make_frame(const Scene& scene, World world);

}  // namespace penumbra
