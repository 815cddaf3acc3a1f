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
#include "tracing/leaving.hpp"
#include "tracing/light.hpp"
#include "tracing/material.hpp"
#include "tracing/ray_kind.hpp"
#include "tracing/record.hpp"
#include "tracing/spread.hpp"

namespace penumbra::PENUMBRA_KERNEL {

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
  [[no_unique_address]] Recorder recorder;
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

// One ray of the several that the hit of an eye ray may send.
struct RayOfHit {
  std::uint32_t number, count;
};

// How many rays a hit sends: those of the first hit are set by the picture, deeper ones send one.
PENUMBRA_INLINE std::uint32_t rays_of_hit(int rays_of_first, TreePlace place) {
  return place == tree_root ? static_cast<std::uint32_t>(rays_of_first) : 1;
}

// The two random numbers for area light `number`. The first one at the eye ray's hit has joint dimensions.
PENUMBRA_INLINE Pair light_numbers(const TraceContext& c, std::uint32_t number, TreePlace place, RayOfHit ray) {
  const std::uint32_t dimension = step(place, step_light + number);
  if (c.frame.settings.regular_lights) {
    return ray.count > 1 ? c.sampler.regular_among(ray.number, ray.count, dimension) : c.sampler.regular(dimension);
  }
  if (ray.count > 1) return c.sampler.among(ray.number, ray.count).pair(dimension);
  if (c.frame.lights[number].first_of_area && place == tree_root) return c.sampler.first_light_place();
  return c.sampler.pair(dimension);
}

// The product of k_trans over all surfaces crossed on the way to a light.
__attribute__((noinline)) inline Floats transmission_on_the_way(const TraceContext& c, const Rays& to_light,
                                                                Mask active) {
  // From surface to surface. The start of a leg looks back at the leg before it.
  struct Leg {
    Rays rays;
    Hits hits{Floats(0)};
    RayStart start;
  } legs[2];
  legs[0].rays = to_light;
  Floats through = keep(active, Floats(1));
  Mask open = active;
  for (int i = 0; any(open) && !to_light.are_given_up(); i = 1 - i) {
    Leg& leg = legs[i];
    leg.hits = intersect(c.frame.world, leg.rays, leg.rays.light_distance, open);
    open = open & leg.hits.found;
    if (none(open)) break;
    const Material material = material_at(c.frame, leg.hits);
    through = select(open, through * material.transmission, through);
    open = open & (through > Floats(0));
    const Mask behind = dot(leg.hits.normal, leg.rays.direction) > Floats(0);
    leg.start = start_at(leg.hits, leg.rays, material, behind);
    Rays& next = legs[1 - i].rays;
    next = leg.rays;
    next.light_distance = leg.rays.light_distance - leg.hits.distance + leg.start.back;
    next.leave(leg.start, Mask(true));
  }
  return through;
}

// How much of the light comes through: 0 or 1, or that product.
PENUMBRA_INLINE Floats visibility(const TraceContext& c, const Rays& to_light, Mask active) {
  c.counts[RayKind::shadow] += static_cast<std::uint64_t>(count(active));
  if (c.frame.settings.transparent_shadows) return transmission_on_the_way(c, to_light, active);
  return keep(active & ~occluded(c.frame.world, to_light, to_light.light_distance, active), Floats(1));
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
  const Floats base = min(max(cosine, Floats(0)), Floats(1));
  if (material.common_power != 0) return whole_power(base, material.common_power);
  const Floats power = whole_power(base, material.whole_power);
  if (!material.any_broken_power) return power;
  return select(material.whole_power == Ints(0u), pow(base, material.specular_power), power);
}

// The normals of hits: for N.L, and on the viewer's side. Often the same.
struct Normals {
  const Float3 *shading, *facing;
};

// The light that arrives from the lights.
inline Float3 direct_light(const TraceContext& c, const Rays& rays, const Hits& hits, const Material& material,
                           const Normals& normals, const RayStart& start, int depth, TreePlace place) {
  const Settings& settings = c.frame.settings;
  const Floats zero = Floats(0);
  Float3 sum{zero, zero, zero};
  Rays shadow;
  shadow.time = rays.time;
  shadow.given_up = rays.given_up;
  shadow.to_light = true;
  shadow.leave(start, Mask(false));
  if (any(hits.smooth)) shadow.origin = select(hits.smooth, shadow.origin + hits.lift, shadow.origin);
  const auto from_point = [&](std::uint32_t number, Pair random) {
    const FrameLight& light = c.frame.lights[number];
    const LightSample sample = sample_light(light, shadow.origin, random);
    const Floats toward_light = dot(*normals.shading, sample.toward);
    const Floats cosine = max(toward_light, zero);
    Mask lit = hits.found;
    if (!material.any_specular) lit &= cosine > zero;
    Floats visible = Floats(1);
    shadow.direction = sample.toward;
    shadow.light_distance = sample.distance;
    if (settings.shadows) {
      // From behind, the light comes through the surface itself; where it is smooth, that is told by its smooth normal.
      Floats in_front = toward_light;
      if (normals.facing != normals.shading) {
        in_front = select(hits.smooth, toward_light, dot(*normals.facing, sample.toward));
      }
      const Mask through = ~(in_front > zero);
      Floats own = Floats(1);
      if (settings.transparent_shadows) {
        shadow.leave(start, through);
        own = select(through, material.transmission, own);
        lit &= own > zero;
      } else {
        lit &= ~through;
      }
      if (any(lit)) {
        shadow.coherent = !light.has_area && place == tree_root;
        visible = own * visibility(c, shadow, lit);
      }
    }
    c.recorder.shadow(number, shadow, sample.distance, lit, visible, depth);
    lit &= visible > zero;
    if (none(lit)) return Float3{zero, zero, zero};
    Float3 reflected = material.diffuse * cosine;
    if (material.any_specular) {
      reflected += material.specular * highlight(material, *normals.shading, sample.toward, rays.direction);
    }
    reflected = reflected * sample.radiance;
    return keep(lit, settings.transparent_shadows ? reflected * visible : reflected);
  };
  const std::uint32_t light_count = static_cast<std::uint32_t>(c.frame.lights.size());
  for (std::uint32_t number = 0; number < light_count; number++) {
    const bool has_area = c.frame.lights[number].has_area;
    const std::uint32_t points = has_area ? rays_of_hit(settings.shadow_rays, place) : 1;
    for (std::uint32_t k = 0; k < points && !rays.are_given_up(); k++) {
      const Pair random = has_area ? light_numbers(c, number, place, {k, points}) : Pair{zero, zero};
      const Float3 light_of_point = from_point(number, random);
      const Float3 brought = points == 1 ? light_of_point : light_of_point * Floats(1.0f / static_cast<float>(points));
      c.recorder.lit(brought);
      sum += brought;
    }
  }
  return sum;
}

Float3 trace(const TraceContext& c, const Rays& rays, Mask active, int depth, TreePlace place, FirstHits* first);

// How the reflected or the transmitted rays leave a surface.
struct Lobe {
  RayKind kind;
  Floats factor;        // what their mean is worth
  std::uint32_t count;  // of rays
  Float3 direction;     // unit: of the mirror or of Snell's law
  bool spread;          // whether any lane has a radius above zero
  Floats radius;
  Float3 side;  // the normal of the side they leave to
  const RayStart& start;
  TreeStep random_step, ray_step;
};

// What the rays of a lobe bring.
inline Float3 trace_lobe(const TraceContext& c, const Rays& rays, const Lobe& lobe, Mask active, int depth,
                         TreePlace place) {
  c.recorder.announce(lobe.kind, lobe.factor, lobe.count, depth);
  c.counts[lobe.kind] += lobe.count * static_cast<std::uint64_t>(count(active));
  Rays next;
  next.time = rays.time;
  next.given_up = rays.given_up;
  next.leave(lobe.start, Mask(lobe.kind == RayKind::transmission));
  next.direction = lobe.direction;
  const TreePlace next_place = step(place, lobe.ray_step);
  Float3 sum{Floats(0), Floats(0), Floats(0)};
  for (std::uint32_t k = 0; k < lobe.count && !rays.are_given_up(); k++) {
    if (lobe.spread) {
      const Sampler sampler = lobe.count == 1 ? c.sampler : c.sampler.among(k, lobe.count);
      next.direction = spread(lobe.direction, lobe.radius, lobe.side, sampler, step(place, lobe.random_step));
    }
    const Sampler sampler = lobe.count == 1 ? c.sampler : c.sampler.descending(k, lobe.count);
    sum += trace({c.frame, sampler, c.counts, c.recorder}, next, active, depth + 1, next_place, nullptr);
  }
  return keep(active, sum * Floats(1.0f / static_cast<float>(lobe.count)) * lobe.factor);
}

// What the reflected and the transmitted rays bring.
inline Float3 indirect_light(const TraceContext& c, const Rays& rays, const Hits& hits, const Material& material,
                             const Float3& facing, const RayStart& start, int depth, TreePlace place) {
  const Floats zero = Floats(0);
  Float3 sum{zero, zero, zero};
  Floats reflection = material.reflection, gloss_radius = material.gloss_radius;
  bool any_gloss = material.any_gloss;
  Mask transmits(false);
  Floats transmission = material.transmission;
  const RayStart* beyond = &start;
  RayStart on_next;
  Ints next_place;
  const bool smooth = any(hits.smooth);
  Float3 bent = facing;  // the smooth normal, as long as it shows to the viewer
  if (smooth) {
    bent = select(hits.smooth & (dot(hits.smooth_normal, rays.direction) < zero), hits.smooth_normal, facing);
  }
  Float3 refracted = rays.direction;
  if (material.any_transmission) {
    const Floats index = material.refraction_index;
    const Refraction refraction = refract(rays.direction, bent, select(start.behind, index, Floats(1) / index));
    const Mask candidates = hits.found & (material.transmission != zero);
    Mask total = candidates & refraction.total;
    Float3 direction = refraction.direction;
    // Between two solids that touch there is nothing that reflects totally: the rays go from one into the other.
    if (any(total & start.behind)) {
      const SolidBehind behind = solid_behind(c.frame, rays, hits, start, total & start.behind);
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
  const Mask reflects = hits.found & (reflection != zero);
  if (any(reflects)) {
    Float3 mirror = normalize(reflect(rays.direction, bent));
    if (smooth) mirror = select(hits.smooth, fold(mirror, facing), mirror);
    const std::uint32_t count = rays_of_hit(c.frame.settings.reflection_rays, place);
    const Lobe lobe{RayKind::reflection, reflection, count, mirror,     any_gloss,
                    gloss_radius,        facing,     start, step_gloss, step_reflection};
    sum += trace_lobe(c, rays, lobe, reflects, depth, place);
  }
  if (any(transmits)) {
    const std::uint32_t count = rays_of_hit(c.frame.settings.transmission_rays, place);
    const Lobe lobe{RayKind::transmission, transmission, count,   refracted, material.any_blur,
                    material.blur_radius,  -facing,      *beyond, step_blur, step_transmission};
    sum += trace_lobe(c, rays, lobe, transmits, depth, place);
  }
  return sum;
}

// The colour that each active ray sees; `depth` is 0 for eye rays.
inline Float3 trace(const TraceContext& c, const Rays& rays, Mask active, int depth, TreePlace place,
                    FirstHits* first) {
  const Hits hits = intersect(c.frame.world, rays, Floats(__builtin_inff()), active);
  if (first) first->found = hits.found;
  c.recorder.begin(rays, hits, active, depth);
  const auto with_background = [&](Float3 reflected) {
    const Float3 color = select(hits.found, reflected, keep(active, broadcast3(c.frame.background)));
    c.recorder.end(color, depth);
    return color;
  };
  if (none(hits.found)) return with_background(hits.normal);

  const Material material = material_at(c.frame, hits);
  Mask behind = dot(hits.normal, rays.direction) > Floats(0);
  if (rays.any_inward) behind |= rays.inward() & (hits.place == *rays.start->place);
  behind &= hits.found;
  Float3 facing, shading;
  Normals normals{&hits.normal, &hits.normal};
  if (any(behind)) {
    facing = select(behind, -hits.normal, hits.normal);
    shading = select(hits.two_sided, facing, hits.normal);
    normals = {&shading, &facing};
  }
  if (any(hits.smooth)) {
    shading = select(hits.smooth, hits.smooth_normal, *normals.shading);
    normals.shading = &shading;
  }
  if (first) {
    first->distance = hits.distance;
    first->normal = *normals.shading;
    first->albedo = material.diffuse;
  }
  c.recorder.surface(material.ambient, *normals.shading, depth);
  const RayStart start = start_at(hits, rays, material, behind);
  Float3 reflected = material.ambient + direct_light(c, rays, hits, material, normals, start, depth, place);
  if (material.any_reflection && depth < c.frame.settings.max_depth) {
    reflected += indirect_light(c, rays, hits, material, *normals.facing, start, depth, place);
  }
  return with_background(reflected);
}

}  // namespace penumbra::PENUMBRA_KERNEL
