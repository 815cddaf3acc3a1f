// The options of a picture, from the command line or the window, and the scene with them applied. option_table.hpp has
// a row for each of them.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "picture/effect.hpp"
#include "rendering/plan.hpp"
#include "sampling/pattern.hpp"
#include "scene/scene.hpp"

namespace penumbra {

inline constexpr int last_possible_frame = 999'999;

// Frames first, first + step, ... of an animation that runs from `first` to `last`.
struct AnimationRange {
  int first = 0, last = 0, step = 1;

  bool operator==(const AnimationRange&) const = default;
};

struct AnimationFrame {
  int first = 0, last = 0;  // of the animation
  int frame = 0;

  // Maps `own`, the time within the frame (0: it begins, 1: the next one begins), to the time of the animation: 0 where
  // the first frame begins, 1 where the last one begins. The end of a frame and the beginning of the next are the same
  // number, to the bit. An animation of one frame is a still picture: its time is `own`.
  double time_at(double own) const {
    return (static_cast<double>(frame - first) + own) / (last > first ? last - first : 1);
  }

  bool operator==(const AnimationFrame&) const = default;
};

// The camera's axes: right, up, and back along -view.
struct CameraAxes {
  Vec3 right, up, back;

  bool operator==(const CameraAxes&) const = default;
};

// An empty option leaves the scene's own value.
struct PictureOptions {
  std::optional<std::pair<int, int>> size;
  std::optional<int> rays, max_depth;
  std::optional<int> reflection_rays, transmission_rays, shadow_rays, light_rays;
  std::optional<Branching> branching;
  std::optional<PixelFilter> filter;
  std::optional<Pattern> sampler;
  std::optional<std::uint32_t> seed;
  std::optional<PixelRect> crop;
  std::optional<double> noise;    // adaptive: the standard error of a pixel; `rays` is then the most a pixel gets
  std::optional<int> first_rays;  // of every pixel before `noise` looks where more are needed
  std::optional<std::pair<double, double>> shutter;  // open, close
  std::optional<double> time;
  std::optional<AnimationRange> frames;  // `shutter` and `time` then are in a frame's own time
  std::optional<int> frame;              // only this one of them
  std::optional<Vec3> eye;
  std::optional<CameraAxes> uvw;
  std::optional<std::pair<double, double>> lens;  // radius, distance of the plane in focus
  // Later ones win. Gloss applies to surfaces that reflect, blur to those that transmit; numbers count all surfaces.
  std::vector<NumberedRadius> gloss, blur, disk_radius;
  Effects without;
  int exposure_halves = 0;  // stops: brightness doublings, counted in halves
  LensModel lens_model = LensModel::thin;
  bool no_shadows = false, transparent_shadows = false, regular_lights = false;
  Course course = Course::off;         // off: the scene's own
  std::optional<Highlight> highlight;  // of surfaces that leave it open
  bool lenient = false;
  bool allow_paths = false;  // the scene may name files anywhere
  Layers layers;             // besides the colour, in an EXR
  int bits = 8;              // per channel in a PNG

  SampleCounts sample_counts() const { return noise ? SampleCounts::per_pixel : SampleCounts::uniform; }
  // The frame that is rendered; none for a still picture.
  std::optional<AnimationFrame> animation_frame() const {
    if (!frames || !frame) return std::nullopt;
    return AnimationFrame{frames->first, frames->last, *frame};
  }
  bool operator==(const PictureOptions&) const = default;
};

// The sentence about an option that names a light or a surface the scene does not have; empty if none does.
std::string missing_number(const Scene& scene, const PictureOptions& options);

// The scene with the options applied.
Scene with_options(Scene scene, const PictureOptions& options);

}  // namespace penumbra
