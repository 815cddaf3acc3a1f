#include "viewer/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/shell_words.hpp"
#include "picture/option_table.hpp"

namespace penumbra {
namespace {

// Plotting many samples of a scene where each has thousands of rays would block the window.
constexpr std::chrono::milliseconds patience(15);
constexpr std::size_t most_rays_of_plotted_sample = 1024;

struct InPlane {
  double u, v;
};

// The coordinates of p in the plane through `origin` spanned by u and v, in units of u and v.
InPlane in_plane(const float (&u)[3], const float (&v)[3], const float (&origin)[3], const float (&p)[3]) {
  double uu = 0, uv = 0, vv = 0, pu = 0, pv = 0;
  for (int i = 0; i < 3; i++) {
    const double x = double{p[i]} - origin[i];
    uu += double{u[i]} * u[i], uv += double{u[i]} * v[i], vv += double{v[i]} * v[i];
    pu += x * u[i], pv += x * v[i];
  }
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return {0, 0};
  return {(pu * vv - pv * uv) / determinant, (pv * uu - pu * uv) / determinant};
}

class Plotter {
 public:
  explicit Plotter(const Frame& frame) : frame_(frame) {
    pixel_ = add("in the pixel", 0);
    if (frame.camera.has_lens) lens_ = add("on the lens", -1);
    if (frame.camera.shutter_length != 0) time_ = add("in time", 0);
    for (std::size_t i = 0; i < frame.lights.size(); i++) {
      light_.push_back(frame.lights[i].has_area ? add(fmt::format("on light {}", i + 1), -1) : -1);
    }
  }

  void plot(const RayTree& tree, std::uint32_t sample, float u, float v) {
    const FrameCamera& camera = frame_.camera;
    const RecordedRay& eye = tree.rays.front();
    SampleDot dot;
    dot.sample = sample;
    std::copy_n(eye.came_back, 3, dot.color);
    const bool spread = camera.pixel_width != 0;
    put(pixel_, dot, spread ? InPlane{u, v} : InPlane{0.5, 0.5});
    put(lens_, dot, in_plane(camera.lens_u, camera.lens_v, camera.eye, eye.origin));
    if (time_ >= 0) put(time_, dot, {(eye.time - camera.shutter_open) / camera.shutter_length, 0.5});
    for (const RecordedRay& ray : tree.rays) {
      if (ray.kind != RayKind::shadow || ray.parent != 0) continue;
      float point[3];
      for (int i = 0; i < 3; i++) point[i] = ray.origin[i] + ray.direction[i] * ray.light_distance;
      with_light(frame_.lights[ray.light], [&]<typename Kind>(const Kind& light) {
        if constexpr (Kind::has_area) put(light_[ray.light], dot, in_plane(light.u, light.v, light.center, point));
      });
    }
  }

  std::vector<DotPlot> take() { return std::move(plots_); }

 private:
  int add(std::string name, double low) {
    plots_.push_back({std::move(name), low, {}});
    return static_cast<int>(plots_.size()) - 1;
  }
  void put(int plot, SampleDot dot, InPlane place) {
    if (plot < 0) return;
    dot.u = place.u;
    dot.v = place.v;
    plots_[static_cast<std::size_t>(plot)].dots.push_back(dot);
  }

  const Frame& frame_;
  std::vector<DotPlot> plots_;
  int pixel_ = -1, lens_ = -1, time_ = -1;
  std::vector<int> light_;
};

std::string command_for(const Refinement& picture, const RefinedSide& side, const InspectedSample& at) {
  Scene scene = *side.scene;
  scene.settings.rays_per_pixel = static_cast<int>(picture.rays);
  PictureOptions options = side.options;
  options.exposure_halves = 0;
  std::string command = "penumbra render " + shell_word(picture.loaded->path.string());
  for (const auto& [key, value] : metadata_for(picture.loaded->path, scene, options)) {
    if (key == "scene" || key == "version") continue;
    const char join = option_named(key).value_is_optional ? '=' : ' ';
    command += value == "yes" ? " --" + key : fmt::format(" --{}{}{}", key, join, value);
  }
  return command + fmt::format(" --debug-pixel {},{},{}", at.x, at.y, at.sample);
}

}  // namespace

Inspection inspect(const Refinement& picture, const Kernel& kernel, const InspectedSample& at) {
  const RefinedSide& side = picture.sides[static_cast<std::size_t>(at.side)];
  const Frame& frame = *side.frame;
  Inspection inspection;
  inspection.at = at;
  const std::size_t pixel = static_cast<std::size_t>(at.y) * side.image.width + at.x;
  std::copy_n(&side.image.rgb[3 * pixel], 3, inspection.so_far.begin());
  inspection.tree = trace_sample(frame, kernel, at.x, at.y, at.sample, picture.rays);
  inspection.text = ray_tree_text(frame, inspection.tree, at.x, at.y, at.sample);
  inspection.command = command_for(picture, side, at);

  const auto end = std::chrono::steady_clock::now() + patience;
  const std::uint32_t most = std::min(picture.rays, most_plotted_samples);
  std::vector<float> u(most), v(most);
  kernel.sample_points(frame, at.x, at.y, pixel_x, u, v);
  Plotter plotter(frame);
  while (inspection.shown < most && std::chrono::steady_clock::now() < end) {
    const std::uint32_t i = inspection.shown++;
    plotter.plot(trace_sample(frame, kernel, at.x, at.y, i, picture.rays, most_rays_of_plotted_sample), i, u[i], v[i]);
  }
  inspection.plots = plotter.take();
  return inspection;
}

}  // namespace penumbra
