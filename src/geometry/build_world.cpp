// From the scene's tree of objects to groups of leaves: nested groups and small instances taken apart, placements split
// off, a BVH over each group.
#include <algorithm>

#include "base/parallel_for.hpp"
#include "geometry/bvh.hpp"
#include "geometry/maps.hpp"
#include "geometry/shape_leaves.hpp"
#include "geometry/small_instances.hpp"
#include "geometry/triangle_leaves.hpp"
#include "geometry/world.hpp"

namespace penumbra {
namespace {

constexpr std::size_t piece_size = 4096;  // leaves that a thread brings in order at once

class WorldBuilder {
 public:
  WorldBuilder(const Scene& scene, const WorldOptions& options)
      : scene_(scene),
        options_(options),
        triangles_(world_, scene, options_),
        small_instances_(scene, options.embree_threshold) {
    world_.triangles = scene.triangles;
    group_of_definition_.assign(scene.definitions.size(), no_group);
    counted_.assign(scene.definitions.size(), false);
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
    std::size_t instances = 0;      // among the objects of the group
    bool has_instances = false;     // some of them are not taken apart
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
    parts.instances = count_instances(objects);
    add_objects(parts, objects, {translation(-origin), {}});
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

  // The space that objects are placed in, seen from that of the group that they are added to.
  struct Space {
    Affine group_from_here;
    Vec3 motion;               // of the whole, in the space of the group
    bool is_instance = false;  // that is taken apart

    Vec3 motion_of(const Object& object) const { return motion + transform_vector(group_from_here, object.motion); }
  };

  // Analytic shapes that follow each other are added together.
  void add_objects(GroupParts& parts, std::span<const Object> objects, const Space& space) {
    for (std::size_t i = 0; i < objects.size(); i++) {
      std::size_t end = i;
      while (end < objects.size() && is_analytic(objects[end])) end++;
      if (end > i) {
        add_shapes(world_, parts, scene_, options_, objects.subspan(i, end - i), space.group_from_here, space.motion);
      }
      if (end < objects.size()) add(parts, objects[end], space);
      i = end;
    }
  }

  void add(GroupParts& parts, const Object& object, const Space& space) {
    const auto add_kind = [&]<typename Kind>(const Kind& shape) {
      if constexpr (!AnalyticShape<Kind>) add_shape(parts, object, shape, space);
    };
    std::visit(add_kind, object.shape);
  }
  void add_shape(GroupParts& parts, const Object& object, const std::shared_ptr<const Group>& group,
                 const Space& space) {
    add_objects(parts, group->objects, {space.group_from_here, space.motion_of(object), space.is_instance});
  }
  void add_shape(GroupParts& parts, const Object& object, const TriangleRange& range, const Space& space) {
    world_.counts.triangles += range.count;
    world_.has_normals |= range.normals != TriangleRange::flat;
    world_.has_textures |= scene_.surfaces[object.surface].texture != Texture::none;
    const TriangleRun run{range, parts.order, object.surface};
    const Vec3 motion = space.motion_of(object);
    parts.order += range.count;
    if (space.is_instance) {
      triangles_.add_placed(parts, run, space.group_from_here, motion);
    } else if (motion == Vec3{}) {
      parts.runs.push_back(run);
    } else {
      triangles_.add_moving(parts, run, motion);
    }
  }
  void add_shape(GroupParts& parts, const Object& object, const Instance& instance, const Space& space) {
    world_.counts.instances++;
    const Space inside{space.group_from_here * scene_.placements[object.placement], space.motion_of(object), true};
    const std::uint32_t definition = instance.definition;
    // What a definition holds counts once.
    const World::Counts before = world_.counts;
    if (space.is_instance || small_instances_.takes_apart(definition, parts.instances, inside.motion != Vec3{})) {
      add_objects(parts, {&scene_.definitions[definition], 1}, inside);
    } else {
      add_whole(parts, definition, inside);
    }
    if (counted_[definition]) world_.counts = before;
    counted_[definition] = true;
  }
  void add_whole(GroupParts& parts, std::uint32_t definition, const Space& space) {
    std::uint32_t& known = group_of_definition_[definition];
    if (known == no_group) known = add_group({&scene_.definitions[definition], 1}, {});
    const GroupSummary& inside = summaries_[known];
    if (is_empty(inside.bounds)) return;
    const Affine& placement = space.group_from_here;
    Leaf leaf(LeafKind::instance);
    leaf.target = known;
    leaf.placement = add_placement(world_, placement);
    leaf.order = touch_order(leaf.passage, parts.order++);
    const double reach = row_sum(placement) * inside.magnitude + max_component(abs(placement.translation));
    parts.add(leaf, {transform(placement, inside.bounds), space.motion, reach}, instance_cost, options_);
    parts.has_instances = true;
  }

  const Scene& scene_;
  const WorldOptions options_;
  World world_;
  TriangleLeaves triangles_;
  const SmallInstances small_instances_;
  std::vector<bool> counted_;  // definitions whose shapes World::counts has
  std::vector<std::uint32_t> group_of_definition_;
  std::vector<GroupSummary> summaries_;  // of each group of the world
};

}  // namespace

World build_world(const Scene& scene, const WorldOptions& options) { return WorldBuilder(scene, options).build(); }

}  // namespace penumbra
