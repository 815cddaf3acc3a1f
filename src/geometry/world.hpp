// The geometry of a scene, ready to be asked: what does a ray hit first, and is anything in its way. Plain arrays in
// single precision, built once (build_world) and read by all threads.
//
// Two rooms stand behind the two questions: a packet BVH of our own for analytic shapes and small groups of triangles,
// and Embree for large static triangle meshes. Groups of `begin_list` are taken apart; named objects that hold a group
// stay whole, and an instance leaf carries the rays into their space.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/zeroed_pages.hpp"
#include "geometry/leaf.hpp"

struct RTCSceneTy;

namespace penumbra {

struct EmbreeLibrary;

// group = linear * local + translation, and back: local = inverse * (group - translation). Matrices row by row.
struct Placement {
  float linear[9];
  float inverse[9];
  float translation[3];
  float stretch, shrink;  // how much `linear` and `inverse` can enlarge a coordinate (row_sum)
};

// A node's child: an inner node (its index), or a run of leaves: top bit set, then 5 bits of count, 26 bits of first.
using NodeReference = std::uint32_t;
inline constexpr std::uint32_t max_leaves_in_node = 31;
constexpr NodeReference leaf_reference(std::uint32_t first, std::uint32_t count) {
  return 0x80000000u | (count << 26) | first;
}
constexpr bool is_leaf(NodeReference r) { return (r & 0x80000000u) != 0; }
constexpr std::uint32_t leaf_first(NodeReference r) { return r & 0x03ffffffu; }
constexpr std::uint32_t leaf_count(NodeReference r) { return (r >> 26) & 31u; }

// Both children's bounds side by side: bounds[child] = lo.x, lo.y, lo.z, hi.x, hi.y, hi.z.
struct alignas(64) Node {
  float bounds[2][6];
  NodeReference child[2];
};

struct WorldGroup {
  NodeReference root = leaf_reference(0, 0);
  float origin[3] = {0, 0, 0};  // of the space that the group is traced in, in the space of the scene's numbers
};

// Triangles of the store that follow each other both there and in the order of the file.
struct MeshChunk {
  std::uint32_t first = 0;                      // triangle of the store
  std::uint32_t order = 0;                      // of the first triangle; the next ones count up
  std::uint32_t normals = TriangleRange::flat;  // as of a range
  std::uint32_t surface = 0;                    // of all of them, where `surfaces` is empty
  std::vector<std::uint32_t> surfaces;          // one for each triangle, where they differ
};

// One Embree scene: a long run of static triangles; Embree's geometry k is chunk k.
struct Mesh {
  const EmbreeLibrary* embree = nullptr;
  std::shared_ptr<RTCSceneTy> scene;
  std::vector<MeshChunk> chunks;
};

struct World {
  ZeroedVector<Node> nodes;
  ZeroedVector<Leaf> leaves;
  std::vector<Placement> placements;
  std::vector<WorldGroup> groups;  // [0] is the whole scene
  std::vector<Mesh> meshes;
  std::shared_ptr<const TriangleStore> triangles;
  bool has_textures = false;  // texture points are wanted
  bool has_normals = false;   // some triangles have vertex normals
  // For each leaf, if some have: the place of a triangle in the store's `normal_numbers`, in triangles; else `flat`.
  ZeroedVector<std::uint32_t> leaf_normals;

  double reach = 0;  // the largest coordinate, in absolute value, that any hit may have

  // What the scene names: analytic shapes, triangles and instances, those of each definition once.
  struct Counts {
    std::uint64_t shapes = 0, triangles = 0, instances = 0;
    bool operator==(const Counts&) const = default;
  } counts;
};

struct WorldOptions {
  double shutter_open = 0;
  double shutter_close = 1;
  int threads = 1;
  Vec3 origin;                            // of the space that the scene is traced in
  std::uint32_t embree_threshold = 4096;  // runs of at least so many static triangles go to Embree
};

// Flattens, bounds and sorts the scene into a World. Throws std::runtime_error if Embree fails or memory runs out.
World build_world(const Scene& scene, const WorldOptions& options);

}  // namespace penumbra
