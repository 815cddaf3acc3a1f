// Step 5 of Cook's loop: at each hit, shadow rays to points of the lights, and what the surface reflects of the light
// that arrives.
#pragma once

#include "tracing/interaction.hpp"
#include "tracing/light_clusters.hpp"
#include "tracing/tree.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// What a light counts for because of its highlight, as a share of how bright a highlight can be. Most lights have none.
inline constexpr float highlight_share = 0.125f;

// The two random numbers for area light `number`. The first one at the eye ray's hit has joint dimensions.
PENUMBRA_INLINE Pair light_numbers(const TraceContext& c, std::uint32_t number, const TreeNode& node, RayOfHit ray) {
  const std::uint32_t dimension = step(node.place, step_light + number);
  if (c.frame.settings.regular_lights) {
    return ray.count > 1 ? c.sampler.regular_among(ray.number, ray.count, dimension) : c.sampler.regular(dimension);
  }
  if (ray.count > 1) return c.sampler.among(ray.number, ray.count).pair(dimension);
  if (c.frame.lights[number].first_of_area && node.is_root()) return c.sampler.first_light_place();
  return c.sampler.pair(dimension);
}
PENUMBRA_INLINE Pair light_numbers(const TraceContext& c, std::uint32_t number, const LoneNode& node, RayOfHit) {
  const Ints dimension = step(node.place, step_light + number);
  return c.frame.settings.regular_lights ? node.sampler.regular(dimension) : node.sampler.pair(dimension);
}

// The two random numbers that choose a light for shadow ray `ray` and the point on it. Those of the first ray from the
// eye ray's hit are joint dimensions.
PENUMBRA_INLINE Pair random_of_light(const TraceContext& c, std::uint32_t ray, const TreeNode& node) {
  if (ray == 0 && node.is_root()) return c.sampler.first_light_place();
  return c.sampler.pair(step(node.place, step_light + ray));
}
PENUMBRA_INLINE Pair random_of_light(const TraceContext&, std::uint32_t ray, const LoneNode& node) {
  return node.sampler.pair(step(node.place, step_light + ray));
}
// The one that chooses clusters.
PENUMBRA_INLINE Floats random_of_clusters(const TraceContext& c, const TreeNode& node) {
  return c.sampler.alone().single(Ints(step(node.place, step_clusters)));
}
PENUMBRA_INLINE Floats random_of_clusters(const TraceContext&, const LoneNode& node) {
  return node.sampler.single(step(node.place, step_clusters));
}

// What there is to know of a hit to choose a light for it.
PENUMBRA_INLINE LitPoint lit_point_at(const TraceContext& c, const Interaction& at, Float3 from) {
  LitPoint lit{from, *at.normals.shading, Floats(0), false};
  if (!at.material.any_specular) return lit;
  const auto brightness = [](Float3 color) { return abs(color.x) + abs(color.y) + abs(color.z); };
  const Floats diffuse = brightness(at.material.diffuse);
  lit.floor =
      min(brightness(at.material.specular) * Floats(highlight_share) / max(diffuse, Floats(1e-3f)), Floats(1e3f));
  lit.from_behind = c.frame.settings.transparent_shadows || !c.frame.settings.shadows;
  return lit;
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

// The light that arrives from the lights.
template <typename Node>
inline Float3 direct_light(const TraceContext& c, const Interaction& at, const Node& node) {
  const Rays& rays = at.rays;
  const Hits& hits = at.hits;
  const Material& material = at.material;
  const Normals& normals = at.normals;
  const Settings& settings = c.frame.settings;
  const Floats zero = Floats(0);
  Float3 sum{zero, zero, zero};
  Rays shadow;
  shadow.time = rays.time;
  shadow.given_up = rays.given_up;
  shadow.to_light = true;
  shadow.leave(at.start, Mask(false));
  if (any(hits.smooth)) shadow.origin = select(hits.smooth, shadow.origin + hits.lift, shadow.origin);
  // What the surface reflects of the light from a point of light `number`, in `lit`.
  const auto from_point = [&](auto number, const LightSample& sample, Mask lit, bool coherent) {
    const Floats toward_light = dot(*normals.shading, sample.toward);
    const Floats cosine = max(toward_light, zero);
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
        shadow.leave(at.start, through);
        own = select(through, material.transmission, own);
        lit &= own > zero;
      } else {
        lit &= ~through;
      }
      if (any(lit)) {
        shadow.coherent = coherent;
        visible = own * visibility(c, shadow, lit);
      }
    }
    c.recorder.shadow(number, shadow, sample.distance, lit, visible, node.depth);
    lit &= visible > zero;
    if (none(lit)) return Float3{zero, zero, zero};
    Float3 reflected = material.diffuse * cosine;
    if (material.any_specular) {
      reflected += material.specular * highlight(material, *normals.shading, sample.toward, rays.direction);
    }
    reflected = reflected * sample.radiance;
    return keep(lit, settings.transparent_shadows ? reflected * visible : reflected);
  };
  if (c.frame.light_rays > 0) {
    const auto count = static_cast<std::uint32_t>(c.frame.light_rays);
    const LightChoice choice(c.frame.light_clusters, lit_point_at(c, at, shadow.origin), count,
                             random_of_clusters(c, node));
    for (std::uint32_t k = 0; k < count && !rays.are_given_up(); k++) {
      const Pair random = random_of_light(c, k, node);
      const ChosenLight chosen = choice.choose(k, random.u, hits.found);
      if (none(chosen.any)) continue;
      const LightSample sample =
          sample_lights(c.frame.lights, chosen.number, shadow.origin, {chosen.rest, random.v}, chosen.any);
      const Float3 brought = keep(chosen.any, from_point(chosen.number, sample, chosen.any, false) * chosen.worth);
      c.recorder.lit(brought);
      sum += brought;
    }
    return sum;
  }
  const std::uint32_t light_count = static_cast<std::uint32_t>(c.frame.lights.size());
  for (std::uint32_t number = 0; number < light_count; number++) {
    const FrameLight& light = c.frame.lights[number];
    const std::uint32_t points = light.has_area ? rays_of_hit(settings.shadow_rays, node) : 1;
    for (std::uint32_t k = 0; k < points && !rays.are_given_up(); k++) {
      const Pair random = light.has_area ? light_numbers(c, number, node, {k, points}) : Pair{zero, zero};
      const LightSample sample = sample_light(light, shadow.origin, random);
      const Float3 light_of_point = from_point(number, sample, hits.found, !light.has_area && node.is_root());
      const Float3 brought = points == 1 ? light_of_point : light_of_point * Floats(1.0f / static_cast<float>(points));
      c.recorder.lit(brought);
      sum += brought;
    }
  }
  return sum;
}

}  // namespace penumbra::PENUMBRA_KERNEL
