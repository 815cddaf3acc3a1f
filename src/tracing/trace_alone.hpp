// Steps 4 to 6 of Cook's loop where rays go on alone (tracing/branching.hpp): what a ray finds is worth its weight, at
// once, and one ray at most goes on.
#pragma once

#include "tracing/branching.hpp"
#include "tracing/direct_light.hpp"
#include "tracing/lobes.hpp"
#include "tracing/lone_rays.hpp"

namespace penumbra::PENUMBRA_KERNEL {

void trace_alone(const TraceContext& c, LonePacket& packet, Mask active, int depth);

PENUMBRA_INLINE LoneNode alone(const TraceContext& c, const TreeNode& node) {
  return {c.sampler.alone(), Ints(node.place), Ints(static_cast<std::uint32_t>(node.depth)),
          node.depth,        node.weight,      c.lone_rays.slots()};
}

// Lets one of the rays that hits would send go on, or none.
inline void send_alone(const TraceContext& c, const Interaction& at, const Lobes& lobes, const LoneNode& node,
                       Mask reflects, Mask transmits) {
  const Material& material = at.material;
  const Floats random = node.sampler.single(step(node.place, step_choice));
  const Chosen chosen =
      choose_one(node.weight, node.deep, random, reflects, transmits, lobes.reflection, lobes.transmission);
  if (none(chosen.goes_on)) return;
  const Mask through = chosen.through;
  const Float3 facing = *at.normals.facing;
  LonePacket next;
  next.origin = at.start.origin;
  next.direction = select(through, lobes.refracted, lobes.mirror);
  if (lobes.any_gloss || material.any_blur) {
    const Floats radius = material.any_blur ? select(through, material.blur_radius, lobes.gloss_radius)
                                            : keep(~through, lobes.gloss_radius);
    next.direction =
        spread(next.direction, radius, select(through, -facing, facing), node.sampler, step(node.place, step_gloss));
  }
  next.time = at.rays.time;
  next.normal = at.hits.normal;
  next.incoming = at.rays.direction;
  next.slack = at.hits.slack;
  next.back = at.start.back;
  next.nearest = at.start.nearest;
  next.place = select(through, *lobes.beyond->place, at.hits.place);
  next.previous_place = at.rays.start ? *at.rays.start->place : Ints(no_place);
  const auto side = [](Mask lanes, LonePacket::Side bit) { return select(lanes, Ints(bit), Ints(0u)); };
  const Mask behind = (through & lobes.beyond->behind) | (at.start.behind & ~through);
  next.sides = side(through, LonePacket::through) | side(behind, LonePacket::behind) |
               side(at.start.opaque, LonePacket::opaque) | side(at.start.sheet, LonePacket::sheet);
  next.weight = node.weight * chosen.factor;
  next.tree_place = step(node.place, step_chosen);
  next.depth = node.deep + Ints(1u);
  next.key = node.sampler.key;
  next.index = node.sampler.index;
  next.slot = node.slot;
  c.recorder.announce(through, chosen.factor, 1, node.depth);
  c.counts[RayKind::transmission] += static_cast<std::uint64_t>(count(through));
  c.counts[RayKind::reflection] += static_cast<std::uint64_t>(count(chosen.goes_on & ~through));
  if (c.lone_rays.can_wait(chosen.goes_on)) {
    c.lone_rays.push(next, chosen.goes_on);
  } else {
    trace_alone(c, next, chosen.goes_on, node.depth + 1);
  }
}

// `depth` is that of all rays, where it is the same.
inline void trace_alone(const TraceContext& c, LonePacket& packet, Mask active, int depth) {
  const auto is = [&](LonePacket::Side bit) { return ~((packet.sides & Ints(bit)) == Ints(0u)); };
  // The start, with so much of what lies before it as is asked for.
  Rays arrived;
  arrived.direction = packet.incoming;
  RayStart before;
  before.place = &packet.previous_place;
  arrived.start = &before;
  Hits surface{Floats(0)};
  surface.normal = packet.normal;
  surface.slack = packet.slack;
  RayStart start;
  start.arrived = &arrived;
  start.hits = &surface;
  start.place = &packet.place;
  start.one_place = false;
  start.origin = packet.origin;
  start.back = packet.back;
  start.nearest = packet.nearest;
  start.behind = is(LonePacket::behind);
  start.opaque = is(LonePacket::opaque);
  start.sheet = is(LonePacket::sheet);

  Rays rays;
  rays.direction = packet.direction;
  rays.time = packet.time;
  rays.given_up = c.given_up;
  rays.leave(start, is(LonePacket::through));
  LoneSampler sampler = c.sampler.alone();
  sampler.key = packet.key;
  sampler.index = packet.index;
  const LoneNode node{sampler, packet.tree_place, packet.depth, depth, packet.weight, packet.slot};

  const Hits hits = intersect(c.frame.world, rays, Floats(__builtin_inff()), active);
  c.recorder.begin(rays, hits, active, depth);
  Float3 color = broadcast3(c.frame.background);
  if (any(hits.found)) {
    const Interaction at(c.frame, rays, hits);
    c.recorder.surface(at.material.ambient, *at.normals.shading, depth);
    color = select(hits.found, at.material.ambient + direct_light(c, at, node), color);
    const Mask deeper = node.deep < Ints(static_cast<std::uint32_t>(c.frame.settings.max_depth));
    if (at.material.any_reflection && any(deeper & hits.found)) {
      const Lobes lobes(c.frame, at);
      send_alone(c, at, lobes, node, lobes.reflects & deeper, lobes.transmits & deeper);
    }
  }
  c.recorder.end(color, depth);
  c.lone_rays.add(packet.slot, active, color * packet.weight);
}

// Traces all that wait.
inline void trace_waiting(const TraceContext& c) {
  while (!c.lone_rays.empty()) {
    if (c.given_up && c.given_up->load(std::memory_order_relaxed)) return c.lone_rays.drop();
    LonePacket packet;
    const Mask active = c.lone_rays.pop(packet);
    trace_alone(c, packet, active, 0);
  }
}

}  // namespace penumbra::PENUMBRA_KERNEL
