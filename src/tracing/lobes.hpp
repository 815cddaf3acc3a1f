// The two ways in which light comes to a hit from other surfaces: the reflected and the transmitted ray, as they would
// go if nothing spread them.
#pragma once

#include "tracing/interaction.hpp"
#include "tracing/spread.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Lobes {
  Mask reflects, transmits{false};  // which rays are sent
  Floats reflection, transmission;  // what they are worth
  Float3 mirror, refracted;         // where they go: unit
  bool any_gloss;                   // whether reflected rays are spread, and how far
  Floats gloss_radius;
  const RayStart* beyond;  // where transmitted rays start
  // The same, where some go on into another solid that touches the first. `beyond` then points here.
  RayStart on_next;
  Ints next_place;

  PENUMBRA_INLINE Lobes(const Frame& frame, const Interaction& at) {
    const Rays& rays = at.rays;
    const Hits& hits = at.hits;
    const Material& material = at.material;
    const RayStart& start = at.start;
    const Float3& facing = *at.normals.facing;
    const Floats zero = Floats(0);
    reflection = material.reflection;
    transmission = material.transmission;
    gloss_radius = material.gloss_radius;
    any_gloss = material.any_gloss;
    beyond = &start;
    const bool smooth = any(hits.smooth);
    Float3 bent = facing;  // the smooth normal, as long as it shows to the viewer
    if (smooth) {
      bent = select(hits.smooth & (dot(hits.smooth_normal, rays.direction) < zero), hits.smooth_normal, facing);
    }
    refracted = rays.direction;
    if (material.any_transmission) {
      const Floats index = material.refraction_index;
      const Refraction refraction = refract(rays.direction, bent, select(start.behind, index, Floats(1) / index));
      const Mask candidates = hits.found & (material.transmission != zero);
      Mask total = candidates & refraction.total;
      Float3 direction = refraction.direction;
      // Between two solids that touch there is nothing that reflects totally: the rays go from one into the other.
      if (any(total & start.behind)) {
        const SolidBehind behind = solid_behind(frame, rays, hits, start, total & start.behind);
        const Refraction direct = refract(rays.direction, bent, index / behind.refraction_index);
        const Mask passes = behind.touches & ~direct.total;
        total &= ~passes;
        direction = select(passes, direct.direction, direction);
        transmission = select(passes, transmission * behind.transmission, transmission);
        if (any(passes)) {
          next_place = select(passes, behind.place, hits.place);
          on_next = start;
          on_next.place = &next_place;
          on_next.one_place = false;
          on_next.behind = start.behind & ~passes;
          beyond = &on_next;
        }
      }
      reflection = select(total, reflection + material.transmission, reflection);
      // A frosted solid is as frosted from inside.
      if (material.any_blur && any(total)) {
        any_gloss = true;
        gloss_radius = select(total, max(gloss_radius, material.blur_radius), gloss_radius);
      }
      transmits = candidates & ~total;
      refracted = select(index == Floats(1), rays.direction, direction);
      if (smooth) refracted = select(hits.smooth, fold(refracted, -facing), refracted);
    }
    reflects = hits.found & (reflection != zero);
    mirror = rays.direction;
    if (any(reflects)) {
      mirror = normalize(reflect(rays.direction, bent));
      if (smooth) mirror = select(hits.smooth, fold(mirror, facing), mirror);
    }
  }
  Lobes(const Lobes&) = delete;
};

}  // namespace penumbra::PENUMBRA_KERNEL
