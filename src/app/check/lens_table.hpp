// What the lens of a scene does to each of its objects, in numbers: the lecture's slide 48 as a table.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace penumbra {

// A point at distance D along the view, seen through a lens of focal length F and f-number n that is focused at P.
// Where `n` is 0, focal length and f-number are not known, and what needs them is not a number.
struct LensBlur {
  double image_distance;       // V_D = F D / (D - F)
  double radius;               // r = (lens radius) |D - P| / P, with lens radius F / (2n)
  double circle_of_confusion;  // C = (F/n) F |P - D| / (D (P - F)), a diameter, on the image plane of P
  double radius_in_pixels;     // r S / (2 D tan(fov/2)), S the shorter side of the picture
};

// The blur at `distance`, which is greater than zero. The scene's camera has a lens.
LensBlur lens_blur(const Scene& scene, double distance);

// The distance V_P = F P / (P - F) of the image plane behind a `camera_lens`.
double image_plane_distance(const Camera& camera);

// The table, several lines each ended, as part of what `check` says of a picture; empty for a pinhole.
std::string lens_table(const Scene& scene);

}  // namespace penumbra
