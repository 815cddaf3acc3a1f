#include "tracing/frame.hpp"

#include <cmath>
#include <numbers>

namespace penumbra {
namespace {

// Beyond this, squares of numbers in single precision overflow; what is as far is as good as infinitely far.
constexpr double far_away = 1e18;

// Brings the vectors and the lens to numbers whose squares single precision holds. No ray changes its direction; only
// that of a lens so large or so small that its numbers mean nothing.
Camera with_usable_numbers(Camera c) {
  const double size = max_component(max(abs(c.right), max(abs(c.up), abs(c.back))));
  const int exponent = -std::ilogb(size);
  for (Vec3* v : {&c.right, &c.up, &c.back}) *v = scalbn(*v, exponent);
  const double lens = std::max(c.lens_radius, c.focus_distance);
  const double enlarged = lens < 1 / far_away ? 1e-12 / lens : 1;
  c.lens_radius = std::min(c.lens_radius * enlarged, far_away);
  c.focus_distance = std::min(c.focus_distance * enlarged, far_away);
  return c;
}

FrameCamera make_camera(const Scene& scene) {
  const Camera c = with_usable_numbers(scene.camera);
  const Settings& settings = scene.settings;
  FrameCamera camera{};
  const double half_view = std::tan(c.fov_degrees * std::numbers::pi / 360);
  const bool corner_to_corner = settings.course == Course::year_2015;  // outermost pixels lie on the edges of the view
  const double shorter = std::min(settings.width, settings.height);
  const double per_x = 2 * half_view / (corner_to_corner ? std::max(settings.width - 1, 1) : shorter);
  const double per_y = 2 * half_view / (corner_to_corner ? std::max(settings.height - 1, 1) : shorter);
  const double columns = corner_to_corner ? settings.width - 1 : settings.width;
  const double rows = corner_to_corner ? settings.height - 1 : settings.height;
  set3(camera.eye, c.eye - origin_for(c.eye));
  set3(camera.per_x, c.right * per_x);
  set3(camera.per_y, c.up * -per_y);
  set3(camera.corner, c.right * (-0.5 * columns * per_x) + c.up * (0.5 * rows * per_y) - c.back);
  set3(camera.view, -normalize(c.back));
  camera.has_lens = c.lens_radius > 0;
  if (camera.has_lens) {
    set3(camera.lens_u, normalize(c.right) * c.lens_radius);
    set3(camera.lens_v, normalize(c.up) * c.lens_radius);
  }
  camera.focus_distance = static_cast<float>(c.focus_distance);
  camera.shutter_open = static_cast<float>(c.shutter_open);
  camera.shutter_length = static_cast<float>(c.shutter_close - c.shutter_open);
  const bool one_place = settings.rays_per_pixel <= 1 || !settings.antialiasing;
  camera.pixel_width = one_place ? 0.0f : 1.0f;
  camera.pixel_offset = settings.course != Course::off ? (one_place ? 0.0f : -0.5f) : (one_place ? 0.5f : 0.0f);
  return camera;
}

// A light that is too far for single precision moves nearer along its direction, and shrinks as much.
template <class AnyLight>
AnyLight brought_near(AnyLight light) {
  double size = 0;
  const auto visit_vectors = [&light](const auto& visit) {
    visit(light.center);
    if constexpr (AnyLight::has_area) visit(light.u), visit(light.v);
  };
  visit_vectors([&size](const float(&v)[3]) {
    for (const float x : v) size = std::max(size, std::abs(double{x}));
  });
  const double factor = std::min(far_away / size, 1.0);
  visit_vectors([factor](float(&v)[3]) {
    for (float& x : v) x = static_cast<float>(x * factor);
  });
  return light;
}

FrameLight make_light(const Light& light, Vec3 origin) {
  FrameLight made;
  const auto set = [&](const auto& l) {
    set3(made.color, l.color);
    made.hold(brought_near(frame_light(l, origin)));
  };
  std::visit(set, light);
  made.has_area = with_light(made, [](const auto& l) { return l.has_area; });
  return made;
}

// Beyond this, squaring again and again would lose more digits than a logarithm does.
constexpr double largest_whole_power = 4096;

FrameSurface make_surface(const Surface& s) {
  FrameSurface surface{};
  set3(surface.diffuse, s.diffuse);
  set3(surface.ambient, s.ambient);
  set3(surface.specular, s.specular);
  surface.specular_power = static_cast<float>(s.specular_power);
  if (s.specular_power >= 1 && s.specular_power <= largest_whole_power &&
      s.specular_power == std::floor(s.specular_power)) {
    surface.whole_power = static_cast<std::uint32_t>(s.specular_power);
  }
  surface.reflection = static_cast<float>(s.reflection);
  surface.gloss_radius = static_cast<float>(std::min(s.gloss_radius, far_away));
  surface.transmission = static_cast<float>(s.transmission);
  surface.refraction_index = static_cast<float>(s.refraction_index);
  surface.blur_radius = static_cast<float>(std::min(s.blur_radius, far_away));
  surface.texture = s.texture;
  surface.texture_scale = static_cast<float>(s.texture_scale);
  surface.blinn = s.highlight == Highlight::blinn;
  return surface;
}

// Fine enough for any output, coarse enough that the sum of 2^24 samples of this size is exact in 53 bits.
double quantum_for(double largest) { return std::exp2(std::ceil(std::log2(std::max(largest, 1.0))) - quantum_bits); }

double largest_color(const Scene& scene) {
  double light = max_component(abs(scene.background));
  for (const Light& l : scene.lights) light += std::visit([](const auto& x) { return max_component(abs(x.color)); }, l);
  double reflected = 1;
  for (const Surface& s : scene.surfaces) {
    reflected = std::max({reflected, max_component(abs(s.diffuse) + abs(s.specular)), max_component(abs(s.ambient))});
  }
  return light * reflected;
}

}  // namespace

bool filters(const Scene& scene) {
  const Settings& settings = scene.settings;
  return settings.filter != PixelFilter::box && settings.course == Course::off && settings.antialiasing &&
         settings.rays_per_pixel > 1;
}

int chosen_light_rays(const Scene& scene) {
  const Settings& settings = scene.settings;
  const auto lights = static_cast<int>(std::min<std::size_t>(scene.lights.size(), most_hit_rays + 1));
  if (settings.light_rays != automatic_light_rays) return settings.light_rays < lights ? settings.light_rays : 0;
  // Measured: at equal error, all lights are sooner up to about so many (docs/performance.md).
  constexpr int most_lights_for_all = 64, rays = 24;
  const bool averages = settings.course == Course::off && settings.rays_per_pixel > 1;
  return averages && lights > most_lights_for_all ? rays : 0;
}

bool chooses_branches(const Scene& scene) {
  const Settings& settings = scene.settings;
  const auto sends_two = [](const Surface& s) { return s.reflection != 0 && s.transmission != 0; };
  return settings.branching == Branching::automatic && settings.course == Course::off && settings.rays_per_pixel > 1 &&
         std::ranges::any_of(scene.surfaces, sends_two);
}

Vec3 origin_for(Vec3 eye) {
  constexpr double far_from_origin = 64;
  if (max_component(abs(eye)) <= far_from_origin) return {};
  return {std::round(eye.x), std::round(eye.y), std::round(eye.z)};
}

Frame make_frame(const Scene& scene, int threads) {
  WorldOptions world_options;
  world_options.shutter_open = scene.camera.shutter_open;
  world_options.shutter_close = scene.camera.shutter_close;
  world_options.threads = threads;
  world_options.origin = origin_for(scene.camera.eye);
  return make_frame(scene, build_world(scene, world_options));
}

Frame make_frame(const Scene& scene, World world) {
  const Settings& settings = scene.settings;
  Frame frame;
  frame.world = std::move(world);
  frame.origin = origin_for(scene.camera.eye);
  frame.camera = make_camera(scene);
  set3(frame.background, scene.background);
  bool any_area = false;
  for (const Light& light : scene.lights) {
    FrameLight& added = frame.lights.emplace_back(make_light(light, frame.origin));
    added.first_of_area = added.has_area && !any_area;
    any_area |= added.has_area;
  }
  for (const Surface& surface : scene.surfaces) frame.surfaces.push_back(make_surface(surface));
  frame.settings = settings;
  if (filters(scene)) {
    frame.filter = settings.filter;
    frame.filter_steps = make_filter_steps(settings.filter);
  }
  frame.chooses_branches = chooses_branches(scene);
  frame.light_rays = chosen_light_rays(scene);
  if (frame.light_rays > 0) frame.light_clusters = make_light_clusters(frame.lights, frame.light_rays);
  const auto size = [](int count) { return static_cast<std::uint32_t>(count); };
  frame.tables = make_sample_tables(
      settings.pattern,
      {size(settings.rays_per_pixel), size(settings.reflection_rays), size(settings.transmission_rays),
       size(settings.shadow_rays), size(std::max(frame.light_rays, 1))},
      settings.seed);
  frame.color_quantum = quantum_for(std::min(largest_color(scene), double{largest_finite_sample}));
  frame.largest_color =
      static_cast<float>(std::min(std::ldexp(frame.color_quantum, quantum_bits), double{largest_finite_sample}));
  frame.depth_quantum = quantum_for(std::max(max_component(abs(scene.camera.eye - frame.origin)), frame.world.reach));
  return frame;
}

}  // namespace penumbra
