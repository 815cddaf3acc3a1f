// Steps 4 to 6 of Cook's loop (Cook, Porter, Carpenter 1984), for W rays at a time and written as for one: find what
// the rays hit; send shadow rays to a point on every light; send a reflected and a transmitted ray, each spread; add up
//
//   colour = ambient + sum over lights of light * (diffuse * max(0, N.L) + specular * highlight)
//          + k_refl * (what the reflected ray sees) + k_trans * (what the transmitted ray sees).
//
// Every random choice is a dimension of its own, named by the place of the ray in the tree of rays.
#pragma once

#include "tracing/trace_alone.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// What the eye rays saw first, for the picture's other layers.
struct FirstHits {
  Mask found{false};
  Floats distance;
  Float3 normal, albedo;
};

Float3 trace(const TraceContext& c, const Rays& rays, Mask active, const TreeNode& node, FirstHits* first);

// How rays leave a surface.
struct Lobe {
  Mask through;         // they are transmitted, the others reflected
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
inline Float3 trace_lobe(const TraceContext& c, const Rays& rays, const Lobe& lobe, Mask active, const TreeNode& node) {
  c.recorder.announce(lobe.through, lobe.factor, lobe.count, node.depth);
  c.counts[RayKind::transmission] += lobe.count * static_cast<std::uint64_t>(count(active & lobe.through));
  c.counts[RayKind::reflection] += lobe.count * static_cast<std::uint64_t>(count(active & ~lobe.through));
  Rays next;
  next.time = rays.time;
  next.given_up = rays.given_up;
  next.leave(lobe.start, lobe.through);
  next.direction = lobe.direction;
  const Floats share = Floats(1.0f / static_cast<float>(lobe.count));
  TreeNode next_node{node.depth + 1, step(node.place, lobe.ray_step)};
  if (c.frame.chooses_branches) next_node.weight = node.weight * lobe.factor * share;
  Float3 sum{Floats(0), Floats(0), Floats(0)};
  for (std::uint32_t k = 0; k < lobe.count && !rays.are_given_up(); k++) {
    if (lobe.spread) {
      const Sampler sampler = lobe.count == 1 ? c.sampler : c.sampler.among(k, lobe.count);
      next.direction = spread(lobe.direction, lobe.radius, lobe.side, sampler, step(node.place, lobe.random_step));
    }
    const Sampler sampler = lobe.count == 1 ? c.sampler : c.sampler.descending(k, lobe.count);
    sum += trace({c.frame, sampler, c.counts, c.lone_rays, c.given_up, c.recorder}, next, active, next_node, nullptr);
  }
  return keep(active, sum * share * lobe.factor);
}

// What the reflected and the transmitted rays bring.
inline Float3 indirect_light(const TraceContext& c, const Interaction& at, const TreeNode& node) {
  const Settings& settings = c.frame.settings;
  const Float3& facing = *at.normals.facing;
  const Lobes lobes(c.frame, at);
  Mask reflects = lobes.reflects, transmits = lobes.transmits;
  if (c.frame.chooses_branches && !node.is_root()) {
    const Mask one = reflects & transmits & worth_one(node.weight, lobes.reflection, lobes.transmission);
    if (any(one)) send_alone(c, at, lobes, alone(c, node), one, one);
    reflects &= ~one;
    transmits &= ~one;
  }
  Float3 sum{Floats(0), Floats(0), Floats(0)};
  if (any(reflects)) {
    const std::uint32_t count = rays_of_hit(settings.reflection_rays, node);
    const Lobe lobe{Mask(false),        lobes.reflection, count,    lobes.mirror, lobes.any_gloss,
                    lobes.gloss_radius, facing,           at.start, step_gloss,   step_reflection};
    sum += trace_lobe(c, at.rays, lobe, reflects, node);
  }
  if (any(transmits)) {
    const std::uint32_t count = rays_of_hit(settings.transmission_rays, node);
    const Lobe lobe{
        Mask(true), lobes.transmission, count,     lobes.refracted,  at.material.any_blur, at.material.blur_radius,
        -facing,    *lobes.beyond,      step_blur, step_transmission};
    sum += trace_lobe(c, at.rays, lobe, transmits, node);
  }
  return sum;
}

// The colour that each active ray sees, but for what rays bring that go on alone.
inline Float3 trace(const TraceContext& c, const Rays& rays, Mask active, const TreeNode& node, FirstHits* first) {
  const Hits hits = intersect(c.frame.world, rays, Floats(__builtin_inff()), active);
  if (first) first->found = hits.found;
  c.recorder.begin(rays, hits, active, node.depth);
  const auto with_background = [&](Float3 reflected) {
    const Float3 color = select(hits.found, reflected, keep(active, broadcast3(c.frame.background)));
    c.recorder.end(color, node.depth);
    return color;
  };
  if (none(hits.found)) return with_background(hits.normal);

  const Interaction at(c.frame, rays, hits);
  if (first) {
    first->distance = hits.distance;
    first->normal = *at.normals.shading;
    first->albedo = at.material.diffuse;
  }
  c.recorder.surface(at.material.ambient, *at.normals.shading, node.depth);
  Float3 reflected = at.material.ambient + direct_light(c, at, node);
  if (at.material.any_reflection && node.depth < c.frame.settings.max_depth) reflected += indirect_light(c, at, node);
  return with_background(reflected);
}

}  // namespace penumbra::PENUMBRA_KERNEL
