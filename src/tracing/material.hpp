// The surface of every lane's hit, gathered into lanes: one pass for each distinct surface of the packet.
#pragma once

#include "geometry/rays.hpp"
#include "tracing/frame.hpp"
#include "tracing/texture.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Material {
  Float3 diffuse, ambient, specular;
  Floats specular_power;
  Ints whole_power;                // the same where it is a whole number, else 0
  std::uint32_t common_power = 0;  // the whole power of all lanes, where they have one in common
  Floats reflection, gloss_radius;
  Floats transmission, refraction_index, blur_radius;
  Mask blinn{false};
  // What any lane of the packet needs: whole steps are left out where none does, and what they need is not defined.
  bool any_specular = false, any_phong = false, any_broken_power = false;
  bool any_reflection = false, any_transmission = false, any_gloss = false, any_blur = false;

  // Defines what a surface may leave out.
  PENUMBRA_INLINE void clear() {
    diffuse = ambient = specular = {Floats(0), Floats(0), Floats(0)};
    specular_power = reflection = gloss_radius = transmission = blur_radius = Floats(0);
    refraction_index = Floats(1);
    whole_power = Ints(0u);
  }
};

PENUMBRA_INLINE bool is_black(const float (&c)[3]) { return c[0] == 0 && c[1] == 0 && c[2] == 0; }

// Where `whole`, the surface is that of all lanes, and what it does not have stays undefined.
template <bool whole>
PENUMBRA_INLINE void add_surface(const FrameSurface& s, Mask lanes, const Hits& hits, Material& m) {
  const auto set = [&](auto& field, auto value) {
    if constexpr (whole) {
      field = value;
    } else {
      field = select(lanes, value, field);
    }
  };
  set(m.diffuse, broadcast3(s.diffuse));
  set(m.ambient, broadcast3(s.ambient));
  set(m.transmission, Floats(s.transmission));
  if (!is_black(s.specular)) {
    set(m.specular, broadcast3(s.specular));
    set(m.specular_power, Floats(s.specular_power));
    set(m.whole_power, Ints(s.whole_power));
    if constexpr (whole) m.common_power = s.whole_power;
    m.any_broken_power |= s.whole_power == 0;
    m.any_specular = true;
    if (s.blinn) m.blinn |= lanes;
    m.any_phong |= !s.blinn;
  }
  if (s.reflection != 0 || s.transmission != 0) {
    set(m.reflection, Floats(s.reflection));
    set(m.gloss_radius, Floats(s.gloss_radius));
    m.any_reflection = true;
    m.any_gloss |= s.gloss_radius != 0;
  }
  if (s.transmission != 0) {
    set(m.refraction_index, Floats(s.refraction_index));
    set(m.blur_radius, Floats(s.blur_radius));
    m.any_transmission = true;
    m.any_blur |= s.blur_radius != 0;
  }
  if (s.texture != Texture::none) set(m.diffuse, texture_color(s, lanes, hits.texture_point));
}

// Defined in the lanes that hit.
inline Material material_at(const Frame& frame, const Hits& hits) {
  Material m;
  alignas(64) std::uint32_t surface_of_lane[lane_count];
  store(surface_of_lane, hits.surface);
  Mask open = hits.found;
  while (any(open)) {
    const std::uint32_t surface = surface_of_lane[__builtin_ctz(bits(open))];
    const Mask same = open & (hits.surface == Ints(surface));
    if (bits(same) == bits(hits.found)) {
      add_surface<true>(frame.surfaces[surface], same, hits, m);
      return m;
    }
    if (bits(open) == bits(hits.found)) m.clear();
    add_surface<false>(frame.surfaces[surface], same, hits, m);
    open = open & ~same;
  }
  return m;
}

}  // namespace penumbra::PENUMBRA_KERNEL
