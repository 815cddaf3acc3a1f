#include "geometry/triangle_leaves.hpp"

#include <array>
#include <utility>

#include "geometry/embree_library.hpp"

namespace penumbra {
namespace {

Vec3 vector_of(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

// Whether two triangles lie in one plane and face the same way, as exactly as single precision tells.
bool same_plane(const LeafTriangle& t, const LeafTriangle& other) {
  const Vec3 normal = vector_of(t.normal), corner = vector_of(t.a);
  if (length(vector_of(other.normal) - normal) > slack_share) return false;
  const Vec3 corners[] = {vector_of(other.a), vector_of(other.b), vector_of(other.c)};
  return std::ranges::all_of(
      corners, [&](Vec3 v) { return std::abs(dot(normal, v - corner)) <= slack_share * max_component(abs(v)); });
}

bool follows(const TriangleRun& a, const TriangleRun& b) {
  const std::uint32_t normals =
      a.range.normals == TriangleRange::flat ? a.range.normals : a.range.normals + a.range.count;
  return b.range.first == a.range.first + a.range.count && b.order == a.order + a.range.count &&
         b.range.normals == normals;
}

}  // namespace

void TriangleLeaves::add_moving(GroupLeaves& group, const TriangleRun& run, Vec3 motion) {
  if (run.range.count >= options_.embree_threshold) {
    add_mesh(group, {run}, motion);
  } else {
    add_singly(group, run, motion);
  }
}

void TriangleLeaves::add_static(GroupLeaves& group, const std::vector<TriangleRun>& runs) {
  const auto is_long = [&](std::uint64_t count) { return count >= options_.embree_threshold; };
  for (std::size_t begin = 0; begin < runs.size();) {
    std::size_t end = begin + 1;
    std::uint64_t count = runs[begin].range.count;
    while (!is_long(runs[end - 1].range.count) && end < runs.size() && !is_long(runs[end].range.count) &&
           follows(runs[end - 1], runs[end])) {
      count += runs[end++].range.count;
    }
    const std::vector<TriangleRun> joined(runs.begin() + static_cast<std::ptrdiff_t>(begin),
                                          runs.begin() + static_cast<std::ptrdiff_t>(end));
    if (is_long(count)) {
      add_mesh(group, joined, {});
    } else {
      for (const TriangleRun& run : joined) add_singly(group, run, {});
    }
    begin = end;
  }
}

void TriangleLeaves::add_mesh(GroupLeaves& group, const std::vector<TriangleRun>& runs, Vec3 motion) {
  Mesh mesh;
  std::vector<TriangleRange> ranges;
  for (std::size_t i = 0; i < runs.size(); i++) {
    const TriangleRun& run = runs[i];
    const bool joins = i > 0 && follows(runs[i - 1], run);
    if (!joins) {
      mesh.chunks.push_back({run.range.first, run.order, run.range.normals, run.surface, {}});
      ranges.push_back({run.range.first, 0});
    }
    MeshChunk& chunk = mesh.chunks.back();
    if (run.surface != chunk.surface || !chunk.surfaces.empty()) {
      chunk.surfaces.resize(ranges.back().count, chunk.surface);
      chunk.surfaces.resize(ranges.back().count + run.range.count, run.surface);
    }
    ranges.back().count += run.range.count;
  }
  Bounds bounds;
  for (const TriangleRange& range : ranges) bounds = include(bounds, bounds_of(*scene_.triangles, range));
  mesh.embree = &embree_library();
  mesh.scene = device_.build(*scene_.triangles, ranges);
  Leaf leaf(LeafKind::mesh);
  if (group.origin != Vec3{}) leaf.placement = add_placement(world_, translation(-group.origin));
  leaf.passage = passage_of(scene_.surfaces[runs.front().surface], true);
  leaf.order = runs.front().order;
  leaf.target = static_cast<std::uint32_t>(world_.meshes.size());
  world_.meshes.push_back(std::move(mesh));
  group.add(leaf, {shift(bounds, -group.origin), motion, magnitude(bounds)}, mesh_cost, options_);
}

template <typename Corners>
void TriangleLeaves::add_each(GroupLeaves& group, const TriangleRun& run, const Corners& corners, Vec3 motion) {
  const TriangleStore& store = *scene_.triangles;
  const Passage passage = passage_of(scene_.surfaces[run.surface], true);
  const std::size_t first = group.leaves.size();
  for (std::uint32_t i = 0; i < run.range.count; i++) {
    const auto [a, b, c] = corners(run.range.first + i);
    if (!(length(cross(b - a, c - a)) > 0)) continue;  // a triangle without area is never hit
    Leaf leaf(leaf_of_triangle(a, b, c));
    leaf.target = run.surface;
    leaf.passage = passage;
    leaf.order = touch_order(passage, run.order + i);
    group.add(leaf, {include(include({a, a}, b), c), motion}, shape_cost, options_);
    // No ray that leaves a plane meets it again: all triangles of a flat face are one place.
    if (const std::size_t last = group.leaves.size() - 1; last > first) {
      const Leaf& before = group.leaves[last - 1];
      if (same_plane(before.triangle, leaf.triangle)) group.leaves[last].place = before.place;
    }
    const std::uint32_t normals = run.range.normals + i;
    if (run.range.normals == TriangleRange::flat || store.normal_numbers[3 * std::size_t{normals}] == 0) continue;
    group.normals.resize(group.leaves.size() - 1, TriangleRange::flat);
    group.normals.push_back(normals);
  }
}

void TriangleLeaves::add_singly(GroupLeaves& group, const TriangleRun& run, Vec3 motion) {
  const auto corners = [&](std::uint32_t triangle) {
    const auto corner = [&](std::size_t k) { return corner_of(*scene_.triangles, triangle, k) - group.origin; };
    return std::array{corner(0), corner(1), corner(2)};
  };
  add_each(group, run, corners, motion);
}

void TriangleLeaves::add_placed(GroupLeaves& group, const TriangleRun& run, const Affine& group_from_run, Vec3 motion) {
  // A map that mirrors takes the outward side along.
  const bool mirrors = dot(cross(group_from_run.column[0], group_from_run.column[1]), group_from_run.column[2]) < 0;
  const auto corners = [&](std::uint32_t triangle) {
    const auto corner = [&](std::size_t k) {
      return transform_point(group_from_run, corner_of(*scene_.triangles, triangle, k));
    };
    return std::array{corner(0), corner(mirrors ? 2 : 1), corner(mirrors ? 1 : 2)};
  };
  add_each(group, run, corners, motion);
}

}  // namespace penumbra
