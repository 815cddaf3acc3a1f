// A small scene with everything in it, for tests of properties that must hold whatever is rendered.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "sampling/pattern.hpp"

namespace penumbra::test {

// All effects at once.
inline std::string scene_text(int rays) {
  return fmt::format(R"(image_size 53 37
fov 55
rays_per_pixel {}
background 0.2 0.3 0.5
lens 0.05 5
light 3 5 2 0.5 0.4 0.3
disk_light -4 6 0 1.5 0.5 -1 0 0.4 0.5 0.6
quad_light 2 6 1 0.8 0 0.2 0.1 0.3 0.9 0.3 0.2 0.1
spotlight 0 5 -4 0 -1 0 10 30 0.6 0.6 0.2
diffuse 0.6 0.6 0.6 0.1 0.1 0.1
begin
vertex -20 -1 20
vertex 20 -1 20
vertex 0 -1 -40
end
glossy 0.4 0.3 0.2 0.5 0.5 0.5 30 0.4 0.2
sphere 0.9 -1 -0.1 -5
moving_object 0.5 0.2 0
translucent 0.1 0.2 0.1 0.4 0.4 0.4 60 0.2 0.1 0.6 1.5 0.05
push
translate 1 0 -4.5
rotate 40 1 2 3
box -0.5 -0.5 -0.5 0.5 0.5 0.5
pop
surface 0.3 0.1 0.1 0.1 0 0 0.8 0.8 0.8 20 0.3
begin_list
cylinder 0.3 0 0 -0.5 0.5
moving_sphere 0.3 0 0.8 0 0.4 0.9 0
hollow_cylinder 0.4 0.5 0 0 0.7
cone -0.5 0 0.2 0.6 0.4
end_list
named_object thing
push
translate 0.2 0.8 -5.5
rotatez 50
scale 1.2 0.7 1
instance thing
moving_object 0 0.3 0
pop
translate -1.5 1 -6
instance thing
)",
                     rays);
}

// A ball of 8192 triangles: enough for Embree.
inline std::string mesh_text() {
  std::string text;
  const auto vertex = [](int i, int k) {
    const double a = i * std::numbers::pi / 64, b = k * 2 * std::numbers::pi / 64;
    return fmt::format("vertex {} {} {}\n", std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
  };
  for (int i = 0; i < 64; i++) {
    for (int k = 0; k < 64; k++) {
      text += "begin\n" + vertex(i, k) + vertex(i + 1, k) + vertex(i + 1, k + 1) + "end\n";
      text += "begin\n" + vertex(i, k) + vertex(i + 1, k + 1) + vertex(i, k + 1) + "end\n";
    }
  }
  return text;
}

inline constexpr Pattern all_patterns[] = {Pattern::regular, Pattern::random, Pattern::jittered, Pattern::multijittered,
                                           Pattern::poisson, Pattern::halton, Pattern::sobol,    Pattern::bluenoise};

}  // namespace penumbra::test
