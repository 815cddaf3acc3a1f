// The settings of a picture, apart from what it shows, as one value: its size and how its rays are spent. A scene sets
// them, the options of a command change them, and the rendered frame carries them. Most of their limits are here.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/pixel_rect.hpp"
#include "sampling/pattern.hpp"
#include "sampling/pixel_filter.hpp"
#include "scene/course.hpp"

namespace penumbra {

inline constexpr int most_side = 65'536;             // pixels, of the width and of the height
inline constexpr int most_rays_per_pixel = 1 << 24;  // through a pixel
inline constexpr int most_hit_rays = 65'536;         // of one kind, sent from one hit
inline constexpr int most_depth = 100;               // the deepest recursion of rays that fits on the stack

// The two ways in which the lecture simulates a lens (slides 49 and 50).
enum class LensModel : std::uint8_t {
  thin,  // approach 2: from a point of the lens through the point in focus
  cone   // approach 1: from the eye, within a cone of radius r at the distance of what a pinhole would see
};

inline constexpr std::string_view lens_model_names[] = {"thin", "cone"};

// Settings::light_rays: all lights where there are few or all pixels have one ray, else chosen ones.
inline constexpr int automatic_light_rays = -1;

// What is traced where a surface reflects and transmits.
enum class Branching : std::uint8_t {
  full,      // both rays, down to the last depth
  automatic  // both where they count, then one of them
};

inline constexpr std::string_view branching_names[] = {"full", "auto"};

struct Settings {
  int width = 300, height = 300;  // pixels
  int rays_per_pixel = 1;
  Pattern pattern = default_pattern;
  std::uint32_t seed = 0;
  int max_depth = 8;  // the eye ray has depth 0; at this depth, no further rays are sent
  // How many rays the hit of an eye ray sends: reflected, transmitted, to each area light. Deeper hits send one each.
  int reflection_rays = 1, transmission_rays = 1, shadow_rays = 1;
  int light_rays = automatic_light_rays;  // that each hit sends in all, to lights it chooses; 0: to all lights
  Branching branching = Branching::automatic;
  LensModel lens_model = LensModel::thin;
  bool regular_lights = false;       // area lights are sampled at a fixed regular set of points
  bool shadows = true;               // if not, every light reaches every surface
  bool transparent_shadows = false;  // shadow rays pass through surfaces, times k_trans for each
  PixelFilter filter = PixelFilter::box;
  bool antialiasing = true;     // if not, every ray goes where a single one would
  Course course = Course::off;  // its pixels, its rounding, its shapes under matrices

  bool operator==(const Settings&) const = default;
};

}  // namespace penumbra
