// From the scene's tree of objects to groups of leaves: nested groups taken apart, single shapes freed from their
// instances, placements split off, a BVH over each group.
#include <algorithm>

#include "base/parallel_for.hpp"
#include "geometry/bvh.hpp"
#include "geometry/maps.hpp"
#include "geometry/shape_leaves.hpp"
#include "geometry/triangle_leaves.hpp"
#include "geometry/world.hpp"

namespace penumbra {
namespace {

constexpr std::size_t piece_size = 4096;  // leaves that a thread brings in order at once

class WorldBuilder {
 public:
  WorldBuilder(const Scene& scene, const WorldOptions& options)
      : scene_(scene), options_(options), triangles_(world_, scene, options_) {
    world_.triangles = scene.triangles;
    group_of_definition_.assign(scene.definitions.size(), no_group);
  }

  World build() {
    add_group(scene_.root.objects, options_.origin);
    if (world_.has_normals) world_.leaf_normals.resize(world_.leaves.size(), TriangleRange::flat);
    return std::move(world_);
  }

 private:
  static constexpr std::uint32_t no_group = 0xffffffffu;

  // What collects the leaves of one group.
  struct GroupParts : GroupLeaves {
    std::vector<TriangleRun> runs;  // static triangles, waiting for the choice of a room
    bool has_instances = false;
  };

  // What the instances of a finished group need to know of it.
  struct GroupSummary {
    Bounds bounds;
    std::uint32_t first_leaf = 0;
    std::uint32_t places = 0;  // leaves, with those inside of its instances
    double magnitude = 0;
  };

  // Builds a group of objects, and first those inside of its instances; returns its index.
  std::uint32_t add_group(std::span<const Object> objects, Vec3 origin) {
    const auto group = static_cast<std::uint32_t>(world_.groups.size());
    world_.groups.emplace_back();
    summaries_.emplace_back();
    GroupParts parts;
    parts.origin = origin;
    add_objects(parts, objects, {});
    triangles_.add_static(parts, parts.runs);
    const auto first_leaf = static_cast<std::uint32_t>(world_.leaves.size());
    const Bvh bvh = build_bvh(std::move(parts.items), first_leaf, options_.threads, world_.nodes);
    world_.groups[group].root = bvh.root;
    set3(world_.groups[group].origin, origin);
    take_leaves(parts, bvh.order);
    const std::uint32_t places = number_places(first_leaf, parts.has_instances);
    summaries_[group] = {bvh.bounds, first_leaf, places, parts.magnitude};
    world_.reach = std::max(world_.reach, parts.magnitude);
    return group;
  }

  // Appends the leaves of a group to those of the world, in the order of its hierarchy.
  void take_leaves(const GroupParts& parts, std::span<const std::uint32_t> order) {
    const std::size_t first = world_.leaves.size();
    world_.leaves.resize(first + order.size());
    parallel_for((order.size() + piece_size - 1) / piece_size, options_.threads, [&](std::size_t piece) {
      for (std::size_t i = piece * piece_size; i < std::min(order.size(), (piece + 1) * piece_size); i++) {
        Leaf& leaf = world_.leaves[first + i];
        leaf = parts.leaves[order[i]];
        leaf.place += static_cast<std::uint32_t>(first);
      }
    });
    if (parts.normals.empty()) return;
    world_.leaf_normals.resize(first, TriangleRange::flat);
    for (const std::uint32_t leaf : order) {
      world_.leaf_normals.push_back(leaf < parts.normals.size() ? parts.normals[leaf] : TriangleRange::flat);
    }
  }

  // Numbers the places inside of the instances of the last group, behind its own; returns how many there are in all.
  std::uint32_t number_places(std::uint32_t first_leaf, bool has_instances) {
    auto places = static_cast<std::uint32_t>(world_.leaves.size()) - first_leaf;
    if (!has_instances) return places;
    for (std::size_t i = first_leaf; i < world_.leaves.size(); i++) {
      Leaf& leaf = world_.leaves[i];
      if (leaf.kind != LeafKind::instance) continue;
      const GroupSummary& inside = summaries_[leaf.target];
      leaf.place = first_leaf + places - inside.first_leaf;
      places += inside.places;
    }
    return places;
  }

  // Analytic shapes that follow each other are added together.
  void add_objects(GroupParts& parts, std::span<const Object> objects, Vec3 motion) {
    for (std::size_t i = 0; i < objects.size(); i++) {
      std::size_t end = i;
      while (end < objects.size() && is_analytic(objects[end])) end++;
      if (end > i) {
        add_shapes(world_, parts, scene_, options_, objects.subspan(i, end - i), translation(-parts.origin), motion);
      }
      if (end < objects.size()) add(parts, objects[end], motion);
      i = end;
    }
  }

  void add(GroupParts& parts, const Object& object, Vec3 group_motion) {
    const Vec3 motion = group_motion + object.motion;
    const auto add_kind = [&]<typename Kind>(const Kind& shape) {
      if constexpr (!AnalyticShape<Kind>) add_shape(parts, object, shape, motion);
    };
    std::visit(add_kind, object.shape);
  }
  void add_shape(GroupParts& parts, const Object&, const std::shared_ptr<const Group>& group, Vec3 motion) {
    add_objects(parts, group->objects, motion);
  }
  void add_shape(GroupParts& parts, const Object& object, const TriangleRange& range, Vec3 motion) {
    world_.triangle_count += range.count;
    world_.has_normals |= range.normals != TriangleRange::flat;
    world_.has_textures |= scene_.surfaces[object.surface].texture != Texture::none;
    const TriangleRun run{range, parts.order, object.surface};
    parts.order += range.count;
    if (motion == Vec3{}) {
      parts.runs.push_back(run);
    } else {
      triangles_.add_moving(parts, run, motion);
    }
  }
  void add_shape(GroupParts& parts, const Object& object, const Instance& instance, Vec3 motion) {
    world_.instance_count++;
    const Affine placement = translation(-parts.origin) * scene_.placements[object.placement];
    const Object& definition = scene_.definitions[instance.definition];
    // An instance of one analytic shape is that shape under the product of the matrices, unless its texture needs the
    // space between the two.
    if (is_analytic(definition) && scene_.surfaces[definition.surface].texture == Texture::none) {
      return add_shapes(world_, parts, scene_, options_, {&definition, 1}, placement, motion);
    }
    std::uint32_t& known = group_of_definition_[instance.definition];
    if (known == no_group) known = add_group({&definition, 1}, {});
    const GroupSummary& inside = summaries_[known];
    if (is_empty(inside.bounds)) return;
    Leaf leaf(LeafKind::instance);
    leaf.target = known;
    leaf.placement = add_placement(world_, placement);
    leaf.order = touch_order(leaf.passage, parts.order++);
    const double reach = row_sum(placement) * inside.magnitude + max_component(abs(placement.translation));
    parts.add(leaf, {transform(placement, inside.bounds), motion, reach}, instance_cost, options_);
    parts.has_instances = true;
  }

  const Scene& scene_;
  const WorldOptions options_;
  World world_;
  TriangleLeaves triangles_;
  std::vector<std::uint32_t> group_of_definition_;
  std::vector<GroupSummary> summaries_;  // of each group of the world
};

}  // namespace

World build_world(const Scene& scene, const WorldOptions& options) { return WorldBuilder(scene, options).build(); }

}  // namespace penumbra
