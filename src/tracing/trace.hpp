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

// How much of the light comes through: 0 or 1, or the product of k_trans over all surfaces crossed on the way.
inline Floats visibility(const TraceContext& c, const Rays& to_light, Mask active) {
  const World& world = c.frame.world;
  c.counts[RayKind::shadow] += static_cast<std::uint64_t>(count(active));
  if (!c.frame.settings.transparent_shadows) {
    return keep(active & ~occluded(world, to_light, to_light.light_distance, active), Floats(1));
  }
  Floats through = keep(active, Floats(1));
  Rays rays = to_light;
  RayStart start;
  Float3 normal;
  Mask open = active;
  while (any(open)) {
    const Hits hits = intersect(world, rays, rays.light_distance, open);
    open = open & hits.found;
    if (none(open)) break;
    const Material material = material_at(c.frame, hits);
    through = select(open, through * material.transmission, through);
    open = open & (through > Floats(0));
    const Floats scale = scale_at(hits);
    const Mask behind = dot(hits.normal, rays.direction) > Floats(0);
    start = start_through(start_at(hits, rays, material, behind, scale), Mask(true));
    normal = hits.normal;
    start.normal = &normal;
    start.incoming = &to_light.direction;
    rays.light_distance = rays.light_distance - hits.distance + start.back;
    rays.leave(start, hits.point, scale);
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
  const Floats base = min(max(cosine, Floats(0)), Floats(1));
  if (material.common_power != 0) return whole_power(base, material.common_power);
  const Floats power = whole_power(base, material.whole_power);
  if (!material.any_broken_power) return power;
  return select(material.whole_power == Ints(0u), pow(base, material.specular_power), power);
}

// The normals of hits: for N.L, and on the viewer's side.
struct Normals {
  Float3 shading, facing;
  bool same;  // whether they are, in all lanes that hit
};

// The light that arrives from the lights.
inline Float3 direct_light(const TraceContext& c, const Rays& rays, const Hits& hits, const Material& material,
                           const Normals& normals, const RayStart& start, Floats scale, int depth, TreePlace place) {
  const Settings& settings = c.frame.settings;
  const Floats zero = Floats(0);
  Float3 sum{zero, zero, zero};
  RayStart start_behind;
  Rays shadow;
  shadow.time = rays.time;
  shadow.to_light = true;
  shadow.leave(start, hits.point, scale);
  if (any(hits.smooth)) shadow.origin = select(hits.smooth, shadow.origin + hits.lift, shadow.origin);
  const auto from_point = [&](std::uint32_t number, Pair random) {
    const FrameLight& light = c.frame.lights[number];
    const LightSample sample = sample_light(light, shadow.origin, random);
    const Floats toward_light = dot(normals.shading, sample.toward);
    const Floats cosine = max(toward_light, zero);
    Mask lit = hits.found;
    if (!material.any_specular) lit &= cosine > zero;
    Floats visible = Floats(1);
    shadow.direction = sample.toward;
    shadow.light_distance = sample.distance;
    if (settings.shadows) {
      // From behind, the light comes through the surface itself; where it is smooth, that is told by its smooth normal.
      Floats in_front = toward_light;
      if (!normals.same) in_front = select(hits.smooth, toward_light, dot(normals.facing, sample.toward));
      const Mask through = ~(in_front > zero);
      Floats own = Floats(1);
      if (settings.transparent_shadows) {
        start_behind = start_through(start, through);
        shadow.start = &start_behind;
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
      reflected += material.specular * highlight(material, normals.shading, sample.toward, rays.direction);
    }
    reflected = reflected * sample.radiance;
    return keep(lit, settings.transparent_shadows ? reflected * visible : reflected);
  };
  const std::uint32_t light_count = static_cast<std::uint32_t>(c.frame.lights.size());
  for (std::uint32_t number = 0; number < light_count; number++) {
    const bool has_area = c.frame.lights[number].has_area;
    const std::uint32_t points = has_area ? rays_of_hit(settings.shadow_rays, place) : 1;
    for (std::uint32_t k = 0; k < points; k++) {
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
inline Float3 trace_lobe(const TraceContext& c, const Rays& rays, const Hits& hits, Floats scale, const Lobe& lobe,
                         Mask active, int depth, TreePlace place) {
  c.recorder.announce(lobe.kind, lobe.factor, lobe.count, depth);
  c.counts[lobe.kind] += lobe.count * static_cast<std::uint64_t>(count(active));
  Rays next;
  next.time = rays.time;
  next.leave(lobe.start, hits.point, scale);
  next.direction = lobe.direction;
  const TreePlace next_place = step(place, lobe.ray_step);
  Float3 sum{Floats(0), Floats(0), Floats(0)};
  for (std::uint32_t k = 0; k < lobe.count; k++) {
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
                             Float3 facing, const RayStart& start, Floats scale, int depth, TreePlace place) {
  const Floats zero = Floats(0);
  Float3 sum{zero, zero, zero};
  Floats reflection = material.reflection, gloss_radius = material.gloss_radius;
  bool any_gloss = material.any_gloss;
  Mask transmits(false);
  Floats transmission = material.transmission;
  RayStart beyond = start_through(start, Mask(true));
  const bool smooth = any(hits.smooth);
  Float3 bent = facing;  // the smooth normal, as long as it shows to the viewer
  if (smooth) {
    bent = select(hits.smooth & (dot(hits.smooth_normal, rays.direction) < zero), hits.smooth_normal, facing);
  }
  Float3 refracted = rays.direction;
  if (material.any_transmission) {
    const Floats index = material.refraction_index;
    const Refraction refraction = refract(rays.direction, bent, select(start.inward, index, Floats(1) / index));
    const Mask candidates = hits.found & (material.transmission != zero);
    Mask total = candidates & refraction.total;
    Float3 direction = refraction.direction;
    // Between two solids that touch there is nothing that reflects totally: the rays go from one into the other.
    if (any(total & start.inward)) {
      const SolidBehind behind = solid_behind(c.frame, rays, hits, start, scale, total & start.inward);
      const Refraction direct = refract(rays.direction, bent, index / behind.refraction_index);
      const Mask passes = behind.touches & ~direct.total;
      total &= ~passes;
      direction = select(passes, direct.direction, direction);
      transmission = select(passes, transmission * behind.transmission, transmission);
      beyond.place = select(passes, behind.place, beyond.place);
      beyond.one_place = beyond.one_place && none(passes);
      beyond.inward |= passes;
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
    sum += trace_lobe(c, rays, hits, scale, lobe, reflects, depth, place);
  }
  if (any(transmits)) {
    const std::uint32_t count = rays_of_hit(c.frame.settings.transmission_rays, place);
    const Lobe lobe{RayKind::transmission, transmission, count,  refracted, material.any_blur,
                    material.blur_radius,  -facing,      beyond, step_blur, step_transmission};
    sum += trace_lobe(c, rays, hits, scale, lobe, transmits, depth, place);
  }
  return sum;
}

// The colour that each active ray sees; `depth` is 0 for eye rays.
inline Float3 trace(const TraceContext& c, const Rays& rays, Mask active, int depth, TreePlace place,
                    FirstHits* first) {
  const Hits hits = intersect(c.frame.world, rays, Floats(__builtin_inff()), active);
  Float3 color = keep(active & ~hits.found, broadcast3(c.frame.background));
  if (first) first->found = hits.found;
  c.recorder.begin(rays, hits, active, depth);
  if (none(hits.found)) {
    c.recorder.end(color, depth);
    return color;
  }

  const Material material = material_at(c.frame, hits);
  Mask behind = dot(hits.normal, rays.direction) > Floats(0);
  if (rays.start) behind |= rays.start->inward & (hits.place == rays.start->place);
  behind &= hits.found;
  Normals normals{hits.normal, hits.normal, none(behind)};
  if (!normals.same) {
    normals.facing = select(behind, -hits.normal, hits.normal);
    normals.shading = select(hits.two_sided, normals.facing, hits.normal);
  }
  if (any(hits.smooth)) {
    normals.shading = select(hits.smooth, hits.smooth_normal, normals.shading);
    normals.same = false;
  }
  if (first) {
    first->distance = hits.distance;
    first->normal = normals.shading;
    first->albedo = material.diffuse;
  }
  c.recorder.surface(material.ambient, normals.shading, depth);
  const Floats scale = scale_at(hits);
  const RayStart start = start_at(hits, rays, material, behind, scale);
  Float3 reflected = material.ambient + direct_light(c, rays, hits, material, normals, start, scale, depth, place);
  if (material.any_reflection && depth < c.frame.settings.max_depth) {
    reflected += indirect_light(c, rays, hits, material, normals.facing, start, scale, depth, place);
  }
  color += keep(hits.found, reflected);
  c.recorder.end(color, depth);
  return color;
}

}  // namespace penumbra::PENUMBRA_KERNEL
