// The surface of every lane's hit, gathered into lanes: one pass for each distinct surface of the packet.
#pragma once

#include "geometry/rays.hpp"
#include "tracing/frame.hpp"
#include "tracing/texture.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Material {
  Float3 diffuse, ambient, specular;
  Floats specular_power;
  Floats reflection, gloss_radius;
  Floats transmission, refraction_index, blur_radius;
  Mask blinn;
  // What any lane of the packet needs: whole steps are left out where none does.
  bool any_specular = false, any_phong = false;
  bool any_reflection = false, any_transmission = false, any_gloss = false, any_blur = false;

  PENUMBRA_INLINE Material()
      : specular_power(0.0f),
        reflection(0.0f),
        gloss_radius(0.0f),
        transmission(0.0f),
        refraction_index(1.0f),
        blur_radius(0.0f),
        blinn(false) {
    diffuse = ambient = specular = {Floats(0), Floats(0), Floats(0)};
  }
};

PENUMBRA_INLINE bool is_black(const float (&c)[3]) { return c[0] == 0 && c[1] == 0 && c[2] == 0; }

PENUMBRA_INLINE void add_surface(const FrameSurface& s, Mask lanes, const Hits& hits, Material& m) {
  m.diffuse = select(lanes, broadcast3(s.diffuse), m.diffuse);
  m.ambient = select(lanes, broadcast3(s.ambient), m.ambient);
  if (!is_black(s.specular)) {
    m.specular = select(lanes, broadcast3(s.specular), m.specular);
    m.specular_power = select(lanes, Floats(s.specular_power), m.specular_power);
    m.any_specular = true;
    if (s.blinn) m.blinn |= lanes;
    m.any_phong |= !s.blinn;
  }
  if (s.reflection != 0 || s.transmission != 0) {
    m.reflection = select(lanes, Floats(s.reflection), m.reflection);
    m.gloss_radius = select(lanes, Floats(s.gloss_radius), m.gloss_radius);
    m.any_reflection = true;
    m.any_gloss |= s.gloss_radius != 0;
  }
  if (s.transmission != 0) {
    m.transmission = select(lanes, Floats(s.transmission), m.transmission);
    m.refraction_index = select(lanes, Floats(s.refraction_index), m.refraction_index);
    m.blur_radius = select(lanes, Floats(s.blur_radius), m.blur_radius);
    m.any_transmission = true;
    m.any_blur |= s.blur_radius != 0;
  }
  if (s.texture != Texture::none) {
    m.diffuse = select(lanes, texture_color(s, lanes, hits.texture_point), m.diffuse);
  }
}

inline Material material_at(const Frame& frame, const Hits& hits) {
  Material m;
  alignas(64) std::uint32_t surface_of_lane[lane_count];
  store(surface_of_lane, hits.surface);
  Mask open = hits.found;
  while (any(open)) {
    const std::uint32_t surface = surface_of_lane[__builtin_ctz(bits(open))];
    const Mask same = open & (hits.surface == Ints(surface));
    add_surface(frame.surfaces[surface], same, hits, m);
    open = open & ~same;
  }
  return m;
}

}  // namespace penumbra::PENUMBRA_KERNEL
