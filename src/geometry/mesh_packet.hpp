// Packets of rays against one Embree mesh. Embree names the triangle; distance, point and normal are computed here, by
// the arithmetic of our own triangles, so that both rooms agree on what is equally far.
#pragma once

#include "geometry/embree_mesh.hpp"
#include "geometry/rays.hpp"
#include "geometry/shapes/triangle.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// As wide as one vector of a packet.
#if PENUMBRA_LANES == 16
using EmbreeRays = RTCRay16;
using EmbreeRayHits = RTCRayHit16;
inline constexpr auto embree_intersect = &EmbreeLibrary::rtcIntersect16;
inline constexpr auto embree_occluded = &EmbreeLibrary::rtcOccluded16;
#elif PENUMBRA_LANES == 8
using EmbreeRays = RTCRay8;
using EmbreeRayHits = RTCRayHit8;
inline constexpr auto embree_intersect = &EmbreeLibrary::rtcIntersect8;
inline constexpr auto embree_occluded = &EmbreeLibrary::rtcOccluded8;
#else
using EmbreeRays = RTCRay4;
using EmbreeRayHits = RTCRayHit4;
inline constexpr auto embree_intersect = &EmbreeLibrary::rtcIntersect4;
inline constexpr auto embree_occluded = &EmbreeLibrary::rtcOccluded4;
#endif

// The lanes of one vector, which is what Embree takes.
PENUMBRA_INLINE void store_half(float* p, Floats a, int half) {
  __builtin_memcpy(p, half == 0 ? &a.lo : &a.hi, sizeof a.lo);
}
PENUMBRA_INLINE void store_half(std::uint32_t* p, Ints a, int half) {
  __builtin_memcpy(p, half == 0 ? &a.lo : &a.hi, sizeof a.lo);
}

// Embree is asked a little further than the nearest hit so far, so that a tie is never lost to its rounding; and on the
// way to a light, not so far that a mesh in which the light lies may stop it.
inline constexpr float tie_margin = 1.0f + 1.0f / (1 << 19);
inline constexpr float light_margin = 1.0f - 1.0f / (1 << 15);

// Embree cannot be told where rays start: they start off the surface, and see nothing for a few times as far.
PENUMBRA_INLINE Rays rays_off_start(const World& world, const Rays& rays) {
  Rays off = rays;
  if (rays.start) {
    const StartHere start = start_here(world, rays);
    off.origin = rays.origin + start.normal * select(rays.inward(), -start.error, start.error);
    off.nearest = start.error * Floats(4);
  }
  return off;
}

PENUMBRA_INLINE void fill(EmbreeRays& out, const Rays& rays, Floats farthest, int half) {
  if (rays.to_light) farthest = min(farthest, rays.light_distance * Floats(light_margin));
  store_half(out.org_x, rays.origin.x, half);
  store_half(out.org_y, rays.origin.y, half);
  store_half(out.org_z, rays.origin.z, half);
  store_half(out.dir_x, rays.direction.x, half);
  store_half(out.dir_y, rays.direction.y, half);
  store_half(out.dir_z, rays.direction.z, half);
  store_half(out.tnear, rays.nearest, half);
  store_half(out.tfar, farthest, half);
  store_half(out.time, Floats(0), half);
  store_half(out.mask, Ints(0xffffffffu), half);
  store_half(out.flags, Ints(0u), half);
}

// The corners of the triangles that Embree found, relative to nothing: in the space of the mesh.
struct MeshTriangles {
  Float3 a, b, c;
  Ints surface, order;
};

inline MeshTriangles triangles_found(const World& world, const Leaf& leaf, const std::uint32_t* geometry,
                                     const std::uint32_t* primitive, Mask found) {
  const Mesh& mesh = world.meshes[leaf.target];
  alignas(64) float corner[9][lane_count] = {};
  alignas(64) std::uint32_t surface[lane_count] = {};
  alignas(64) std::uint32_t order[lane_count] = {};
  for (std::uint32_t open = bits(found); open != 0; open &= open - 1) {
    const int lane = __builtin_ctz(open);
    const MeshChunk& chunk = mesh.chunks[geometry[lane]];
    const std::uint32_t* index = world.triangles->indices.data() + std::size_t{3} * (chunk.first + primitive[lane]);
    for (int k = 0; k < 3; k++) {
      const float* p = world.triangles->vertices.data() + std::size_t{3} * index[k];
      for (int axis = 0; axis < 3; axis++) corner[3 * k + axis][lane] = p[axis];
    }
    surface[lane] = chunk.surfaces.empty() ? chunk.surface : chunk.surfaces[primitive[lane]];
    order[lane] = touch_order(leaf.passage, chunk.order + primitive[lane]);
  }
  const auto corner_at = [&](int k) {
    return Float3{load(corner[3 * k]), load(corner[3 * k + 1]), load(corner[3 * k + 2])};
  };
  return {corner_at(0), corner_at(1), corner_at(2), load(surface), load(order)};
}

// Fills in the normals of the corners for the lanes that have them, and tells which.
inline Mask normals_found(const World& world, const Mesh& mesh, const std::uint32_t* geometry,
                          const std::uint32_t* primitive, Mask lanes, Corner (&corners)[3]) {
  alignas(64) float normal[9][lane_count] = {};
  std::uint32_t smooth = 0;
  for (std::uint32_t open = bits(lanes); open != 0; open &= open - 1) {
    const int lane = __builtin_ctz(open);
    const MeshChunk& chunk = mesh.chunks[geometry[lane]];
    if (chunk.normals == TriangleRange::flat) continue;
    const std::size_t triangle = std::size_t{chunk.normals} + primitive[lane];
    if (world.triangles->normal_numbers[3 * triangle] == 0) continue;
    smooth |= 1u << lane;
    for (std::size_t k = 0; k < 3; k++) {
      const float* n = normal_of(*world.triangles, triangle, k);
      for (std::size_t axis = 0; axis < 3; axis++) normal[3 * k + axis][lane] = n[axis];
    }
  }
  for (int k = 0; k < 3; k++)
    corners[k].normal = {load(normal[3 * k]), load(normal[3 * k + 1]), load(normal[3 * k + 2])};
  return mask_from_bits(smooth);
}

// What Embree finds, for each lane.
struct EmbreeHits {
  alignas(64) std::uint32_t geometry[lane_count];
  alignas(64) std::uint32_t primitive[lane_count];
  alignas(64) float distance[lane_count];
};

// Half a packet at a time: packets are as wide as Embree's only so that it does not show who shares one.
PENUMBRA_INLINE Mask find_in_mesh(const Mesh& mesh, const Rays& rays, Floats farthest, Mask active, EmbreeHits& hits) {
  const Ints invalid = Ints(RTC_INVALID_GEOMETRY_ID);
  const Ints active_bits = lane_bits(active);
  store(hits.geometry, invalid);
  for (int half = 0; half < 2; half++) {
    const std::size_t first = static_cast<std::size_t>(half) * vector_lanes;
    if ((bits(active) >> first & ((1u << vector_lanes) - 1u)) == 0) continue;
    alignas(64) EmbreeRayHits query;
    fill(query.ray, rays, farthest, half);
    store_half(query.hit.geomID, invalid, half);
    store_half(query.hit.instID[0], invalid, half);
    store_half(query.ray.id, lane_numbers(), 0);
    alignas(64) std::uint32_t valid[vector_lanes];
    store_half(valid, active_bits, half);
    TieContext tie{{}, &mesh, {}, {}};
    store_half(tie.distance, Floats(-1), half);
    ask_embree(mesh.embree->*embree_intersect, valid, mesh.scene.get(), tie.context, rays.coherent, query);
    __builtin_memcpy(hits.geometry + first, query.hit.geomID, sizeof valid);
    __builtin_memcpy(hits.primitive + first, query.hit.primID, sizeof valid);
    __builtin_memcpy(hits.distance + first, query.ray.tfar, sizeof valid);
  }
  return active & ~(load(hits.geometry) == invalid);
}

// Fills in the lanes whose nearest hit is in this mesh, and tells which. Rays are in the space of the mesh.
inline Mask intersect_mesh(const World& world, const Leaf& leaf, const Rays& rays, Mask active, Hits& hits) {
  const Mesh& mesh = world.meshes[leaf.target];
  EmbreeHits query;
  const Mask found = find_in_mesh(mesh, rays_off_start(world, rays), hits.distance * Floats(tie_margin), active, query);
  if (none(found)) return found;

  const MeshTriangles triangles = triangles_found(world, leaf, query.geometry, query.primitive, found);
  const Float3 across = cross(triangles.b - triangles.a, triangles.c - triangles.a);
  const Floats size = sqrt(dot(across, across));
  const Float3 normal{across.x / size, across.y / size, across.z / size};
  const Floats cosine = dot(normal, rays.direction);
  const Floats plane = dot(normal, triangles.a - rays.origin) / cosine;
  const Mask grazing = ~(cosine * cosine >= Floats(1e-4f) * dot(rays.direction, rays.direction));
  Floats distance = select(grazing | ~(plane > Floats(0)), load(query.distance), plane);
  if (any(found & grazing)) {
    const Float3 a = triangles.a - rays.origin;
    const Crossing own =
        cross_triangle({a, triangles.b - rays.origin, triangles.c - rays.origin, SeenPlane(normal, a, rays.direction)},
                       rays.direction, rays.nearest, RayShear(rays.direction, found));
    distance = select(grazing & own.hit, own.distance, distance);
  }
  Ints order = triangles.order;
  if (leaf.passage == Passage::solid) order = select(cosine > Floats(0), order & Ints(order_mask), order);
  const Mask nearer = found & ((distance < hits.distance) | ((distance == hits.distance) & (order < hits.order)));
  Float3 point = rays.origin + rays.direction * distance;
  point = point - normal * dot(normal, point - triangles.a);
  hits.define();
  hits.distance = select(nearer, distance, hits.distance);
  hits.order = select(nearer, order, hits.order);
  hits.point = select(nearer, point, hits.point);
  hits.normal = select(nearer, normal, hits.normal);
  hits.surface = select(nearer, triangles.surface, hits.surface);
  hits.texture_point = select(nearer, point, hits.texture_point);
  // From the upper end, where no leaf has its place.
  const Ints place = Ints(~rays.first_place) ^ (triangles.order & Ints(order_mask));
  hits.place = select(nearer, place, hits.place);
  hits.one_place = false;
  hits.slack = select(nearer, Floats(leaf.slack), hits.slack);
  hits.two_sided |= nearer;
  hits.found |= nearer;
  if (world.has_normals) {
    Corner corners[3] = {{triangles.a, {}}, {triangles.b, {}}, {triangles.c, {}}};
    const Mask smooth = normals_found(world, mesh, query.geometry, query.primitive, nearer, corners);
    hits.smooth = hits.smooth & ~nearer;
    if (any(smooth)) hits.set_smooth(smooth, smooth_at(corners, point, normal, rays.direction));
  }
  return nearer;
}

// Which of the active rays meet a triangle of the mesh nearer than `farthest`.
inline Mask occluded_mesh(const World& world, const Leaf& leaf, const Rays& rays, Floats farthest, Mask active) {
  const Mesh& mesh = world.meshes[leaf.target];
  const Rays off = rays_off_start(world, rays);
  const Ints active_bits = lane_bits(active);
  alignas(64) float distance[lane_count] = {};
  for (int half = 0; half < 2; half++) {
    const std::size_t first = static_cast<std::size_t>(half) * vector_lanes;
    if ((bits(active) >> first & ((1u << vector_lanes) - 1u)) == 0) continue;
    alignas(64) EmbreeRays query;
    fill(query, off, farthest, half);
    alignas(64) std::uint32_t valid[vector_lanes];
    store_half(valid, active_bits, half);
    EmbreeContext context;
    ask_embree(mesh.embree->*embree_occluded, valid, mesh.scene.get(), context, rays.coherent, query);
    __builtin_memcpy(distance + first, query.tfar, sizeof valid);
  }
  return active & (load(distance) < Floats(0));
}

}  // namespace penumbra::PENUMBRA_KERNEL
