// The commands for the camera and for how its rays are spent.
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "base/parse.hpp"
#include "language/actions.hpp"
#include "language/near_word.hpp"
#include "sampling/pattern.hpp"

namespace penumbra::actions {
namespace {

// Of two vectors that are meant to be at a right angle, written with two digits.
constexpr double largest_cosine = 0.02;

double cosine(Vec3 a, Vec3 b) { return std::abs(dot(normalize(a), normalize(b))); }

// Gives a setting the value of that name.
template <auto setting>
void choose(Reading& reading, const Call& call, std::span<const std::string_view> names) {
  using Choice = std::remove_cvref_t<decltype(std::declval<Settings>().*setting)>;
  const std::string_view name = call.name(0);
  if (const std::optional<Choice> choice = value_named<Choice>(name, names)) {
    reading.builder.change().settings.*setting = *choice;
    return;
  }
  reading.diagnostics.error(
      call.place_of_argument(0),
      fmt::format("there is no {} {}; there are {}", call.command.name, in_quotes(name), fmt::join(names, ", ")),
      did_you_mean(nearest_word(name, {names.begin(), names.end()})));
}

}  // namespace

void fov(Reading& reading, const Call& call) { reading.builder.change().camera.fov_degrees = call[0]; }

void eye(Reading& reading, const Call& call) {
  reading.builder.change().camera.eye = call.vec(0);
  reading.note(Topic::camera, call);
}

void uvw(Reading& reading, const Call& call) {
  const Vec3 u = call.vec(0), v = call.vec(3), w = call.vec(6);
  const double volume = dot(near_unit(u), cross(near_unit(v), near_unit(w)));
  if (!(std::abs(volume) > 0)) {
    return reading.error(call.place(), "the three vectors of `uvw` lie in one plane");
  }
  if (volume < 0) {
    reading.diagnostics.warning(call.place(), "the vectors of `uvw` are left-handed: the picture is mirrored");
  }
  if (std::max({cosine(u, v), cosine(v, w), cosine(w, u)}) > largest_cosine) {
    reading.diagnostics.warning(call.place(), "the vectors of `uvw` are not at right angles: the picture is sheared");
  }
  Camera& camera = reading.builder.change().camera;
  camera.right = u;
  camera.up = v;
  camera.back = w;
  reading.note(Topic::camera, call);
}

void lens(Reading& reading, const Call& call) {
  if (call[0] > 0 && call[1] <= 0) {
    return reading.error(call.place_of_argument(1), "`dist` of `lens` has to be greater than 0; found {}",
                         in_quotes(call.word(1)));
  }
  Camera& camera = reading.builder.change().camera;
  camera.lens_radius = call[0];
  if (call[1] > 0) camera.focus_distance = call[1];
  camera.focal_length = camera.f_number = 0;
  reading.note(Topic::lens, call);
}

void camera_lens(Reading& reading, const Call& call) {
  const double focal_length = call[0], f_number = call[1], focus = call[2];
  const double radius = focal_length / (2 * f_number);
  if (radius > largest_number) {
    return reading.error(call.place_of_argument(1), "the aperture F/n of `camera_lens` is too large");
  }
  if (focus <= focal_length) {
    return reading.error(call.place_of_argument(2), "`P` of `camera_lens` has to be greater than `F`; found {}",
                         in_quotes(call.word(2)));
  }
  Camera& camera = reading.builder.change().camera;
  camera.lens_radius = radius;
  camera.focus_distance = focus;
  camera.focal_length = focal_length;
  camera.f_number = f_number;
  reading.note(Topic::lens, call);
}

void shutter(Reading& reading, const Call& call) {
  if (call[1] < call[0]) {
    return reading.error(call.place_of_argument(1),
                         "the shutter closes before it opens: `close` has to be `open` or more");
  }
  Camera& camera = reading.builder.change().camera;
  camera.shutter_open = call[0];
  camera.shutter_close = call[1];
}

void rays_per_pixel(Reading& reading, const Call& call) {
  set<&Settings::rays_per_pixel>(reading, call);
  reading.note(Topic::rays, call);
}

void sampler(Reading& reading, const Call& call) { choose<&Settings::pattern>(reading, call, pattern_names); }
void filter(Reading& reading, const Call& call) { choose<&Settings::filter>(reading, call, pixel_filter_names); }
void branching(Reading& reading, const Call& call) { choose<&Settings::branching>(reading, call, branching_names); }

}  // namespace penumbra::actions
