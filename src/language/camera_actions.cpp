// The camera, and how its rays are spent.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "language/actions.hpp"
#include "language/near_word.hpp"

namespace penumbra::actions {
namespace {

constexpr std::array samplers{std::string_view{"random"}, std::string_view{"sobol"}};
constexpr std::array samplers_to_come{std::string_view{"regular"},       std::string_view{"jittered"},
                                      std::string_view{"multijittered"}, std::string_view{"poisson"},
                                      std::string_view{"halton"},        std::string_view{"bluenoise"}};
constexpr std::string_view what_there_is = "there are `random` and `sobol`";

template <class List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

void fov(Reading& reading, const Call& call) { reading.builder.change().camera.fov_degrees = call[0]; }

void eye(Reading& reading, const Call& call) { reading.builder.change().camera.eye = call.vec(0); }

void uvw(Reading& reading, const Call& call) {
  const Vec3 u = call.vec(0), v = call.vec(3), w = call.vec(6);
  const double volume = dot(u, cross(v, w));
  if (!(std::abs(volume) > 0)) {
    return reading.diagnostics.error(call.place(), "the three vectors of `uvw` lie in one plane");
  }
  Camera& camera = reading.builder.change().camera;
  camera.right = u;
  camera.up = v;
  camera.back = w;
}

void lens(Reading& reading, const Call& call) {
  if (call[0] > 0 && call[1] <= 0) {
    return reading.diagnostics.error(
        call.place_of_argument(1),
        fmt::format("`dist` of `lens` has to be greater than 0; found {}", in_quotes(call.word(1))));
  }
  Camera& camera = reading.builder.change().camera;
  camera.lens_radius = call[0];
  if (call[1] > 0) camera.focus_distance = call[1];
  camera.focal_length = camera.f_number = 0;
}

void camera_lens(Reading& reading, const Call& call) {
  const double focal_length = call[0], f_number = call[1], focus = call[2];
  const double radius = focal_length / (2 * f_number);
  if (radius > largest_number) {
    return reading.diagnostics.error(call.place_of_argument(1), "the aperture F/n of `camera_lens` is too large");
  }
  if (focus <= focal_length) {
    return reading.diagnostics.error(
        call.place_of_argument(2),
        fmt::format("`P` of `camera_lens` has to be greater than `F`; found {}", in_quotes(call.word(2))));
  }
  Camera& camera = reading.builder.change().camera;
  camera.lens_radius = radius;
  camera.focus_distance = focus;
  camera.focal_length = focal_length;
  camera.f_number = f_number;
}

void shutter(Reading& reading, const Call& call) {
  if (call[1] < call[0]) {
    return reading.diagnostics.error(call.place_of_argument(1),
                                     "the shutter closes before it opens: `close` has to be `open` or more");
  }
  Camera& camera = reading.builder.change().camera;
  camera.shutter_open = call[0];
  camera.shutter_close = call[1];
}

void rays_per_pixel(Reading& reading, const Call& call) { reading.builder.change().rays_per_pixel = call.whole(0); }

void sampler(Reading& reading, const Call& call) {
  const std::string_view name = call.word(0);
  if (contains(samplers, name)) {
    reading.builder.change().sampler = name;
  } else if (contains(samplers_to_come, name)) {
    reading.diagnostics.error(call.place_of_argument(0),
                              fmt::format("the sampler `{}` is not there yet; {}", name, what_there_is));
  } else {
    reading.diagnostics.error(call.place_of_argument(0),
                              fmt::format("there is no sampler {}; {}", in_quotes(name), what_there_is),
                              did_you_mean(nearest_word(name, {samplers.begin(), samplers.end()})));
  }
}

void seed(Reading& reading, const Call& call) { reading.builder.change().seed = static_cast<std::uint32_t>(call[0]); }

void max_depth(Reading& reading, const Call& call) { reading.builder.change().max_depth = call.whole(0); }

void rays_per_hit(Reading& reading, const Call& call) {
  if (call.whole(0) == 1) return;
  reading.diagnostics.error(call.place_of_argument(0),
                            fmt::format("`{}` other than 1 is not there yet", call.command.name));
}

}  // namespace penumbra::actions
