// From the scene's tree of objects to groups of leaves: nested groups taken apart, single shapes freed from their
// instances, placements split off, triangles dealt to the two rooms, a BVH over each group.
#include <algorithm>
#include <cfloat>

#include "geometry/bvh.hpp"
#include "geometry/embree_library.hpp"
#include "geometry/embree_mesh.hpp"
#include "geometry/maps.hpp"
#include "geometry/world.hpp"

namespace penumbra {
namespace {

// Hit points and ray origins carry errors of this share of their largest coordinate; bounds are wider by as much.
constexpr double bounds_margin = 1.0 / (1 << 20);
// The error of a hit whose surface the numbers of a shape do not give exactly, as a share of its largest coordinate.
constexpr double slack_share = 1.0 / (1 << 21);

constexpr float shape_cost = 1;
constexpr float placed_cost = 2;
constexpr float instance_cost = 8;
constexpr float mesh_cost = 16;

Placement make_placement(const Affine& m) {
  const Affine inv = inverse(m);
  Placement p{};
  for (int row = 0; row < 3; row++) {
    for (int column = 0; column < 3; column++) {
      p.linear[3 * row + column] = static_cast<float>(m.column[column][row]);
      p.inverse[3 * row + column] = static_cast<float>(inv.column[column][row]);
    }
  }
  set3(p.translation, m.translation);
  p.stretch = static_cast<float>(row_sum(m));
  p.shrink = static_cast<float>(row_sum(inv));
  return p;
}

Vec3 vector_of(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

// Whether two triangles lie in one plane and face the same way, as exactly as single precision tells.
bool same_plane(const LeafTriangle& t, const LeafTriangle& other) {
  const Vec3 normal = vector_of(t.normal), corner = vector_of(t.a);
  if (length(vector_of(other.normal) - normal) > slack_share) return false;
  const Vec3 corners[] = {vector_of(other.a), vector_of(other.b), vector_of(other.c)};
  return std::ranges::all_of(
      corners, [&](Vec3 v) { return std::abs(dot(normal, v - corner)) <= slack_share * max_component(abs(v)); });
}

// Whether the numbers of the surface give its points as well as numbers of their size can.
bool is_exact(const Leaf& leaf) {
  if (leaf.placement != no_placement) return false;
  if (leaf.kind == LeafKind::box || (leaf.kind == LeafKind::sphere && leaf.sphere.is_ground)) return true;
  return leaf.kind == LeafKind::triangle &&
         std::ranges::any_of(leaf.triangle.normal, [](float n) { return std::abs(n) == 1; });
}

class WorldBuilder {
 public:
  WorldBuilder(const Scene& scene, const WorldOptions& options)
      : scene_(scene), options_(options), device_(options.threads) {
    world_.triangles = scene.triangles;
    group_of_definition_.assign(scene.definitions.size(), no_group);
  }

  World build() {
    world_.groups.resize(1);
    build_group(0, scene_.root.objects, options_.origin);
    if (world_.has_normals) world_.leaf_normals.resize(world_.leaves.size(), TriangleRange::flat);
    return std::move(world_);
  }

 private:
  static constexpr std::uint32_t no_group = 0xffffffffu;

  // What collects the leaves of one group.
  struct GroupParts {
    ZeroedVector<Leaf> leaves;
    ZeroedVector<BvhItem> items;
    Vec3 origin;  // WorldGroup::origin
    std::uint32_t order = 0;
    double magnitude = 0;  // largest coordinate, in absolute value, on the way to a hit point
    struct Run {           // static triangles, waiting for the choice of a room
      TriangleRange range;
      std::uint32_t order;
      std::uint32_t surface;
    };
    std::vector<Run> runs;
    std::vector<std::uint32_t> normals;  // as World::leaf_normals; those missing at the end are flat
  };

  void build_group(std::uint32_t group, const std::vector<Object>& objects, Vec3 origin) {
    GroupParts parts;
    parts.origin = origin;
    for (const Object& object : objects) add(parts, object, {});
    distribute_triangles(parts);
    const auto first_leaf = static_cast<std::uint32_t>(world_.leaves.size());
    const NodeReference root = build_bvh(parts.items, first_leaf, world_.nodes);
    std::uint32_t places = static_cast<std::uint32_t>(parts.items.size());  // those of instances follow
    world_.leaves.reserve(world_.leaves.size() + parts.leaves.size());
    Bounds bounds;
    for (const BvhItem& item : parts.items) {
      world_.leaves.push_back(parts.leaves[item.leaf]);
      Leaf& leaf = world_.leaves.back();
      if (leaf.kind == LeafKind::instance) {
        leaf.place = first_leaf + places - group_first_leaf_[leaf.target];
        places += group_places_[leaf.target];
      } else {
        leaf.place += first_leaf;
      }
      if (item.leaf < parts.normals.size() && parts.normals[item.leaf] != TriangleRange::flat) {
        world_.leaf_normals.resize(world_.leaves.size() - 1, TriangleRange::flat);
        world_.leaf_normals.push_back(parts.normals[item.leaf]);
      }
      bounds = include(bounds, item.bounds);
    }
    world_.groups[group] = {root, {}};
    set3(world_.groups[group].origin, origin);
    group_bounds_.resize(world_.groups.size());
    group_bounds_[group] = bounds;
    group_first_leaf_.resize(world_.groups.size());
    group_first_leaf_[group] = first_leaf;
    group_places_.resize(world_.groups.size());
    group_places_[group] = places;
    group_magnitude_.resize(world_.groups.size());
    group_magnitude_[group] = parts.magnitude;
    world_.reach = std::max(world_.reach, parts.magnitude);
  }

  void add(GroupParts& parts, const Object& object, Vec3 group_motion) {
    const Vec3 motion = group_motion + object.motion;
    std::visit([&](const auto& shape) { add_shape(parts, object, shape, motion); }, object.shape);
  }
  void add_shape(GroupParts& parts, const Object&, const std::shared_ptr<const Group>& group, Vec3 motion) {
    for (const Object& member : group->objects) add(parts, member, motion);
  }
  void add_shape(GroupParts& parts, const Object& object, const TriangleRange& range, Vec3 motion) {
    add_triangles(parts, range, object.surface, motion);
  }
  template <AnalyticShape Shape>
  void add_shape(GroupParts& parts, const Object& object, const Shape& shape, Vec3 motion) {
    place_shape(parts, shape, object.surface, translation(-parts.origin) * scene_.placements[object.placement], motion);
  }
  void add_shape(GroupParts& parts, const Object& object, const Instance& instance, Vec3 motion) {
    world_.instance_count++;
    const Affine placement = translation(-parts.origin) * scene_.placements[object.placement];
    const Object& definition = scene_.definitions[instance.definition];
    if (add_as_single_shape(parts, definition, placement, motion)) return;
    std::uint32_t group = group_of_definition_[instance.definition];
    if (group == no_group) {
      group = static_cast<std::uint32_t>(world_.groups.size());
      world_.groups.emplace_back();
      build_group(group, {definition}, {});
      group_of_definition_[instance.definition] = group;
    }
    const Bounds inner = group_bounds_[group];
    if (is_empty(inner)) return;
    Leaf leaf(LeafKind::instance);
    leaf.target = group;
    leaf.placement = add_placement(placement);
    const double reach = row_sum(placement) * group_magnitude_[group] + max_component(abs(placement.translation));
    add_leaf(parts, leaf, transform(placement, inner), motion, instance_cost, reach);
  }

  // An instance of one analytic shape is that shape under the product of the matrices, unless its texture needs the
  // space between the two.
  bool add_as_single_shape(GroupParts& parts, const Object& object, const Affine& placement, Vec3 motion) {
    const auto add_if_analytic = [&]<typename Shape>(const Shape& shape) {
      if constexpr (AnalyticShape<Shape>) {
        if (scene_.surfaces[object.surface].texture != Texture::none) return false;
        const Affine product = placement * scene_.placements[object.placement];
        place_shape(parts, shape, object.surface, product, motion + transform_vector(placement, object.motion));
        return true;
      } else {
        return false;
      }
    };
    return std::visit(add_if_analytic, object.shape);
  }

  // A shape that the map keeps of its kind is traced as what it becomes, others behind a placement.
  template <AnalyticShape Shape>
  void place_shape(GroupParts& parts, const Shape& shape, std::uint32_t surface, const Affine& m, Vec3 motion) {
    world_.shape_count++;
    remember_texture(surface);
    const std::optional<Shape> moved = mapped(m, shape);
    Leaf leaf(leaf_of(moved ? *moved : shape));
    leaf.target = surface;
    leaf.passage = passage_of(surface, false);
    if (moved) return add_leaf(parts, leaf, bounds_of(*moved), motion, shape_cost);
    leaf.placement = add_placement(m);
    const double reach = row_sum(m) * magnitude(bounds_of(shape)) + max_component(abs(m.translation));
    add_leaf(parts, leaf, transformed_bounds(m, shape), motion, placed_cost, reach);
  }

  void remember_texture(std::uint32_t surface) {
    world_.has_textures |= scene_.surfaces[surface].texture != Texture::none;
  }

  // Triangles do not tell whether they enclose a solid; what does not refract is a sheet.
  Passage passage_of(std::uint32_t surface, bool triangle) const {
    const Surface& s = scene_.surfaces[surface];
    if (s.transmission == 0) return Passage::opaque;
    return triangle && s.refraction_index == 1 ? Passage::sheet : Passage::solid;
  }

  std::uint32_t add_placement(const Affine& m) {
    world_.placements.push_back(make_placement(m));
    return static_cast<std::uint32_t>(world_.placements.size() - 1);
  }

  // `bounds` at time 0; `reach` is the largest coordinate met on the way to a hit, if larger than the bounds'.
  void add_leaf(GroupParts& parts, Leaf leaf, const Bounds& bounds, Vec3 motion, float cost, double reach = 0) {
    leaf.order = touch_order(leaf.passage, parts.order++);
    add_ordered_leaf(parts, leaf, bounds, motion, cost, reach);
  }
  void add_ordered_leaf(GroupParts& parts, Leaf leaf, const Bounds& bounds, Vec3 motion, float cost, double reach) {
    set3(leaf.motion, motion);
    leaf.moves = motion != Vec3{};
    leaf.place = static_cast<std::uint32_t>(parts.leaves.size());
    const Bounds over_shutter =
        include(shift(bounds, motion * options_.shutter_open), shift(bounds, motion * options_.shutter_close));
    const double largest = std::max({magnitude(bounds), magnitude(over_shutter), reach});
    parts.magnitude = std::max(parts.magnitude, largest);
    if (leaf.moves || !is_exact(leaf)) leaf.slack = static_cast<float>(largest * slack_share);
    parts.items.push_back(
        {grow(over_shutter, largest * bounds_margin + DBL_MIN), static_cast<std::uint32_t>(parts.leaves.size()), cost});
    parts.leaves.push_back(leaf);
  }

  void add_triangles(GroupParts& parts, TriangleRange range, std::uint32_t surface, Vec3 motion) {
    world_.triangle_count += range.count;
    remember_texture(surface);
    world_.has_normals |= range.normals != TriangleRange::flat;
    const std::uint32_t order = parts.order;
    parts.order += range.count;
    if (motion == Vec3{}) {
      parts.runs.push_back({range, order, surface});
    } else if (range.count >= options_.embree_threshold) {
      add_mesh(parts, {{range, order, surface}}, motion);
    } else {
      add_single_triangles(parts, {range, order, surface}, motion);
    }
  }

  // Joins the small static runs that follow each other; what is long then goes to Embree, the rest to our BVH. A long
  // run is an Embree scene of its own: at equal distance Embree's rounding would decide inside one scene, we do between
  // two.
  void distribute_triangles(GroupParts& parts) {
    const auto is_long = [&](std::uint64_t count) { return count >= options_.embree_threshold; };
    for (std::size_t begin = 0; begin < parts.runs.size();) {
      std::size_t end = begin + 1;
      std::uint64_t count = parts.runs[begin].range.count;
      while (!is_long(parts.runs[end - 1].range.count) && end < parts.runs.size() &&
             !is_long(parts.runs[end].range.count) && follows(parts.runs[end - 1], parts.runs[end])) {
        count += parts.runs[end++].range.count;
      }
      const std::vector<GroupParts::Run> joined(parts.runs.begin() + static_cast<std::ptrdiff_t>(begin),
                                                parts.runs.begin() + static_cast<std::ptrdiff_t>(end));
      if (is_long(count)) {
        add_mesh(parts, joined, {});
      } else {
        for (const GroupParts::Run& run : joined) add_single_triangles(parts, run, {});
      }
      begin = end;
    }
  }

  static bool follows(const GroupParts::Run& a, const GroupParts::Run& b) {
    const std::uint32_t normals =
        a.range.normals == TriangleRange::flat ? a.range.normals : a.range.normals + a.range.count;
    return b.range.first == a.range.first + a.range.count && b.order == a.order + a.range.count &&
           b.range.normals == normals;
  }

  void add_mesh(GroupParts& parts, const std::vector<GroupParts::Run>& runs, Vec3 motion) {
    Mesh mesh;
    std::vector<TriangleRange> ranges;
    for (std::size_t i = 0; i < runs.size(); i++) {
      const GroupParts::Run& run = runs[i];
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
    if (parts.origin != Vec3{}) leaf.placement = add_placement(translation(-parts.origin));
    leaf.passage = passage_of(runs.front().surface, true);
    leaf.order = runs.front().order;
    leaf.target = static_cast<std::uint32_t>(world_.meshes.size());
    world_.meshes.push_back(std::move(mesh));
    add_ordered_leaf(parts, leaf, shift(bounds, -parts.origin), motion, mesh_cost, magnitude(bounds));
  }

  void add_single_triangles(GroupParts& parts, const GroupParts::Run& run, Vec3 motion) {
    const std::size_t first = parts.leaves.size();
    for (std::uint32_t i = 0; i < run.range.count; i++) {
      const std::uint32_t triangle = run.range.first + i;
      const Vec3 a = corner_of(*scene_.triangles, triangle, 0) - parts.origin;
      const Vec3 b = corner_of(*scene_.triangles, triangle, 1) - parts.origin;
      const Vec3 c = corner_of(*scene_.triangles, triangle, 2) - parts.origin;
      if (!(length(cross(b - a, c - a)) > 0)) continue;  // a triangle without area is never hit
      Leaf leaf(leaf_of_triangle(a, b, c));
      leaf.target = run.surface;
      leaf.passage = passage_of(run.surface, true);
      leaf.order = touch_order(leaf.passage, run.order + i);
      const Bounds bounds = include(include({a, a}, b), c);
      add_ordered_leaf(parts, leaf, bounds, motion, shape_cost, 0);
      // No ray that leaves a plane meets it again: all triangles of a flat face are one place.
      if (const std::size_t last = parts.leaves.size() - 1; last > first) {
        const Leaf& before = parts.leaves[last - 1];
        if (same_plane(before.triangle, leaf.triangle)) parts.leaves[last].place = before.place;
      }
      const std::uint32_t normals = run.range.normals + i;
      if (run.range.normals == TriangleRange::flat || scene_.triangles->normal_numbers[3 * std::size_t{normals}] == 0)
        continue;
      parts.normals.resize(parts.leaves.size() - 1, TriangleRange::flat);
      parts.normals.push_back(normals);
    }
  }

  const Scene& scene_;
  const WorldOptions options_;
  EmbreeDevice device_;
  World world_;
  std::vector<std::uint32_t> group_of_definition_;
  std::vector<Bounds> group_bounds_;
  std::vector<std::uint32_t> group_first_leaf_, group_places_;  // leaves, with those inside of its instances
  std::vector<double> group_magnitude_;
};

}  // namespace

World build_world(const Scene& scene, const WorldOptions& options) { return WorldBuilder(scene, options).build(); }

}  // namespace penumbra
