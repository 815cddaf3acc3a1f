// Steps 4 to 6 of Cook's loop (Cook, Porter, Carpenter 1984), for W rays at a time and written as for one: find what
// the rays hit; send shadow rays to a point on every light; send a reflected and a transmitted ray, each spread; add up
//
//   colour = ambient + sum over lights of light * (diffuse * max(0, N.L) + specular * highlight)
//          + k_refl * (what the reflected ray sees) + k_trans * (what the transmitted ray sees).
//
// Every random choice is a dimension of its own, named by the place of the ray in the tree of rays.
#pragma once

#include "geometry/traversal.hpp"
#include "sampling/sampler.hpp"
#include "tracing/frame.hpp"
#include "tracing/kernel.hpp"
#include "tracing/light.hpp"
#include "tracing/material.hpp"
#include "tracing/spread.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// New rays start off the surface by this share of the largest coordinate that went into the hit point, and see nothing
// for a few times as far: where two surfaces cross, the point lies on both.
inline constexpr float surface_offset = 1.0f / (1 << 20);
inline constexpr float blind_distance = 4 * surface_offset;

// What the eye rays saw first, for the picture's other layers.
struct FirstHits {
  Mask found{false};
  Floats distance;
  Float3 normal, albedo;
};

struct TraceContext {
  const Frame& frame;
  const Sampler& sampler;
  RayCounts& counts;
};

// The place of a ray in its tree, as a hash; the eye ray's is the root.
using TreePlace = std::uint32_t;
inline constexpr TreePlace tree_root = 0x1b873593u;
enum TreeStep : std::uint32_t {
  step_reflection = 1,
  step_transmission = 2,
  step_gloss = 3,
  step_blur = 5,
  step_light = 8
};
PENUMBRA_INLINE std::uint32_t step(TreePlace place, std::uint32_t number) { return hash(place, number); }

// The two random numbers for a light. The first light of the eye ray's hit has joint dimensions.
PENUMBRA_INLINE Pair light_numbers(const TraceContext& c, const FrameLight& light, std::uint32_t number,
                                   TreePlace place) {
  if (light.kind != LightKind::disk) return {Floats(0), Floats(0)};
  if (number == 0 && place == tree_root) {
    return {c.sampler.joint(first_light_radius), c.sampler.joint(first_light_angle)};
  }
  return c.sampler.pair(step(place, step_light + number));
}

// How much of the light comes through: 0 or 1, or the product of k_trans over all surfaces crossed on the way.
inline Floats visibility(const TraceContext& c, const Rays& to_light, Floats distance, Mask active) {
  const World& world = c.frame.world;
  c.counts.shadow += static_cast<std::uint64_t>(count(active));
  if (!c.frame.options.transparent_shadows) {
    return keep(active & ~occluded(world, to_light, distance, active), Floats(1));
  }
  Floats through = keep(active, Floats(1));
  Rays rays = to_light;
  Floats left = distance;
  Mask open = active;
  while (any(open)) {
    const Hits hits = intersect(world, rays, left, open);
    open = open & hits.found;
    if (none(open)) break;
    const Material material = material_at(c.frame, hits);
    through = select(open, through * material.transmission, through);
    const Floats skip = hits.distance + hits.magnitude * Floats(2 * surface_offset);
    rays.origin = select(open, rays.origin + rays.direction * skip, rays.origin);
    left = left - keep(open, skip);
    open = open & (through > Floats(0)) & (left > Floats(0));
  }
  return through;
}

// max(0, N.H)^p or max(0, R.V)^p
inline Floats highlight(const Material& material, Float3 normal, Float3 toward_light, Float3 direction) {
  Floats cosine = Floats(0);
  if (material.any_phong) {
    cosine = -dot(normal * (Floats(2) * dot(normal, toward_light)) - toward_light, direction);
  }
  if (any(material.blinn)) {
    const Float3 half = toward_light - direction;
    const Floats blinn = dot(normal, half) * (Floats(1) / sqrt(max(dot(half, half), Floats(1e-30f))));
    cosine = select(material.blinn, blinn, cosine);
  }
  cosine = max(cosine, Floats(0));
  return pow(min(cosine, Floats(1)), material.specular_power);
}

// The light that arrives from the lights. `shading` is the normal for N.L, `facing` the one on the viewer's side.
inline Float3 direct_light(const TraceContext& c, const Rays& rays, const Hits& hits, const Material& material,
                           Float3 shading, Float3 facing, TreePlace place) {
  const TracingOptions& options = c.frame.options;
  const Floats zero = Floats(0);
  Float3 sum{zero, zero, zero};
  Rays shadow;
  shadow.time = rays.time;
  shadow.origin = hits.point + facing * (hits.magnitude * Floats(surface_offset));
  shadow.nearest = hits.magnitude * Floats(blind_distance);
  const std::uint32_t light_count = static_cast<std::uint32_t>(c.frame.lights.size());
  for (std::uint32_t number = 0; number < light_count; number++) {
    const FrameLight& light = c.frame.lights[number];
    const LightSample sample = sample_light(light, shadow.origin, light_numbers(c, light, number, place));
    const Floats cosine = max(dot(shading, sample.toward), zero);
    Mask lit = hits.found;
    if (!material.any_specular) lit &= cosine > zero;
    // From behind, the surface itself is in the way.
    if (options.shadows && !options.transparent_shadows) lit &= dot(facing, sample.toward) > zero;
    Floats visible = Floats(1);
    if (options.shadows && any(lit)) {
      shadow.direction = sample.toward;
      shadow.coherent = light.kind != LightKind::disk && place == tree_root;
      visible = visibility(c, shadow, sample.distance, lit);
      lit &= visible > zero;
    }
    if (none(lit)) continue;
    Float3 reflected = material.diffuse * cosine;
    if (material.any_specular) {
      reflected += material.specular * highlight(material, shading, sample.toward, rays.direction);
    }
    sum += keep(lit, reflected * sample.radiance * visible);
  }
  return sum;
}

Float3 trace(const TraceContext& c, const Rays& rays, Mask active, int depth, TreePlace place, FirstHits* first);

// What a ray sees that starts on the surface, on the side that `side` points to.
inline Float3 trace_from(const TraceContext& c, const Rays& rays, const Hits& hits, Float3 direction, Float3 side,
                         Mask active, int depth, TreePlace place) {
  Rays next;
  next.time = rays.time;
  next.origin = hits.point + side * (hits.magnitude * Floats(surface_offset));
  next.nearest = hits.magnitude * Floats(blind_distance);
  next.direction = direction;
  return trace(c, next, active, depth, place, nullptr);
}

// What the reflected and the transmitted rays bring.
inline Float3 indirect_light(const TraceContext& c, const Rays& rays, const Hits& hits, const Material& material,
                             Float3 facing, Mask entering, int depth, TreePlace place) {
  const Floats zero = Floats(0);
  Float3 sum{zero, zero, zero};
  Floats reflection = material.reflection;
  Mask transmits(false);
  Float3 refracted = rays.direction;
  if (material.any_transmission) {
    const Floats index = material.refraction_index;
    const Refraction refraction = refract(rays.direction, facing, select(entering, Floats(1) / index, index));
    const Mask candidates = hits.found & (material.transmission != zero);
    reflection = select(candidates & refraction.total, reflection + material.transmission, reflection);
    transmits = candidates & ~refraction.total;
    refracted = select(index == Floats(1), rays.direction, refraction.direction);
  }
  const Mask reflects = hits.found & (reflection != zero);
  if (any(reflects)) {
    Float3 direction = normalize(reflect(rays.direction, facing));
    if (material.any_gloss) {
      direction = spread(direction, material.gloss_radius, facing, c.sampler, step(place, step_gloss));
    }
    c.counts.reflection += static_cast<std::uint64_t>(count(reflects));
    const Float3 seen = trace_from(c, rays, hits, direction, facing, reflects, depth + 1, step(place, step_reflection));
    sum += keep(reflects, seen * reflection);
  }
  if (any(transmits)) {
    if (material.any_blur) {
      refracted = spread(refracted, material.blur_radius, -facing, c.sampler, step(place, step_blur));
    }
    c.counts.transmission += static_cast<std::uint64_t>(count(transmits));
    const Float3 seen =
        trace_from(c, rays, hits, refracted, -facing, transmits, depth + 1, step(place, step_transmission));
    sum += keep(transmits, seen * material.transmission);
  }
  return sum;
}

// The colour that each active ray sees; `depth` is 0 for eye rays.
inline Float3 trace(const TraceContext& c, const Rays& rays, Mask active, int depth, TreePlace place,
                    FirstHits* first) {
  const Hits hits = intersect(c.frame.world, rays, Floats(__builtin_inff()), active);
  Float3 color = keep(active & ~hits.found, broadcast3(c.frame.background));
  if (first) first->found = hits.found;
  if (none(hits.found)) return color;

  const Material material = material_at(c.frame, hits);
  const Mask behind = dot(hits.normal, rays.direction) > Floats(0);
  const Float3 facing = select(behind, -hits.normal, hits.normal);
  const Float3 shading = select(hits.two_sided, facing, hits.normal);
  if (first) {
    first->distance = hits.distance;
    first->normal = shading;
    first->albedo = material.diffuse;
  }
  Float3 reflected = material.ambient + direct_light(c, rays, hits, material, shading, facing, place);
  if (material.any_reflection && depth < c.frame.options.max_depth) {
    reflected += indirect_light(c, rays, hits, material, facing, ~behind, depth, place);
  }
  return color + keep(hits.found, reflected);
}

}  // namespace penumbra::PENUMBRA_KERNEL
