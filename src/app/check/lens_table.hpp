// How the lens of a scene blurs each of its objects, in numbers: the lecture's slide 48 as a table.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace penumbra {

// A point at distance D along the view, seen through a lens of focal length F and f-number n that is focused at P.
// If `n` is 0, focal length and f-number are unknown, and what depends on them is NaN.
struct LensBlur {
  double image_distance;       // V_D = F D / (D - F)
  double radius;               // r = (lens radius) |D - P| / P, with lens radius F / (2n)
  double circle_of_confusion;  // C = (F/n) F |P - D| / (D (P - F)), a diameter, on the image plane of P
  double radius_in_pixels;     // r S / (2 D tan(fov/2)), S the shorter side of the picture
};

// The blur at `distance` > 0. The scene's camera must have a lens.
LensBlur lens_blur(const Scene& scene, double distance);

// V_P = F P / (P - F), the distance of the image plane behind the lens; NaN unless it is a `camera_lens`.
double image_plane_distance(const Camera& camera);

// The table for the summary of a picture, several lines each ended by a newline; empty for a pinhole.
std::string lens_table(const Scene& scene);

}  // namespace penumbra
