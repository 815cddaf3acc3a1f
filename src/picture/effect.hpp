// The six effects of distribution ray tracing, each of which can be left out of a picture (the lecture's "with and
// without"), and the radii that set the strength of three of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace penumbra {

enum class Effect : std::uint8_t {
  antialiasing,  // without: every ray goes through the same point of its pixel
  lens,          // without: a pinhole
  motion,        // without: the shutter closes the moment it opens
  disk_lights,   // without: all area lights shine from their centres only
  gloss,         // without: mirrors reflect sharply
  translucency   // without: transmission is sharp
};

inline constexpr std::string_view effect_names[] = {"antialiasing", "lens",  "motion",
                                                    "disk-lights",  "gloss", "translucency"};
inline constexpr int effect_count = 6;

// A set of effects.
class Effects {
 public:
  bool has(Effect effect) const { return (bits_ >> static_cast<int>(effect)) & 1u; }
  bool empty() const { return bits_ == 0; }
  void add(Effect effect) { bits_ |= 1u << static_cast<int>(effect); }
  void toggle(Effect effect) { bits_ ^= 1u << static_cast<int>(effect); }
  bool operator==(const Effects&) const = default;

 private:
  std::uint32_t bits_ = 0;
};

// The names, separated by commas.
std::string to_string(Effects effects);

// Removes these effects from the scene.
void leave_out(Scene& scene, Effects effects);

// The radius of one light or surface, counted from 1 in the order of the scene, or of all of them (0).
struct NumberedRadius {
  int number = 0;
  double radius = 0;

  bool operator==(const NumberedRadius&) const = default;
};

// Set the radii, in order, of the surfaces that reflect, of those that transmit, and of the disk lights.
void set_gloss(Scene& scene, const std::vector<NumberedRadius>& radii);
void set_blur(Scene& scene, const std::vector<NumberedRadius>& radii);
void set_disk_radius(Scene& scene, const std::vector<NumberedRadius>& radii);

}  // namespace penumbra
