#include "geometry/shape_leaves.hpp"

#include <new>
#include <optional>

#include "base/parallel_for.hpp"
#include "geometry/maps.hpp"

namespace penumbra {
namespace {

constexpr std::size_t piece_size = 4096;  // objects that a thread takes at once
constexpr std::uint32_t needs_placement = no_placement - 1;

// What the leaves of a piece have in common.
struct Piece {
  double magnitude = 0;
  bool has_textures = false;
  std::size_t placed = 0;  // leaves that need a placement
};

// Makes the leaf of an object. A shape that the map keeps of its kind is traced as what it becomes, others behind a
// placement.
struct LeafMaker {
  const Affine& m;
  Leaf& leaf;
  LeafExtent& extent;

  template <AnalyticShape Shape>
  void operator()(const Shape& shape) const {
    if (const std::optional<Shape> moved = mapped(m, shape)) {
      new (&leaf) Leaf(leaf_of(*moved));
      extent.bounds = bounds_of(*moved);
      return;
    }
    new (&leaf) Leaf(leaf_of(shape));
    leaf.placement = needs_placement;
    extent.bounds = transformed_bounds(m, shape);
    extent.reach = row_sum(m) * magnitude(bounds_of(shape)) + max_component(abs(m.translation));
  }
  template <class Other>
  void operator()(const Other&) const {
    __builtin_unreachable();
  }
};

}  // namespace

void add_shapes(World& world, GroupLeaves& group, const Scene& scene, const WorldOptions& options,
                std::span<const Object> objects, const Affine& outer, Vec3 motion) {
  const std::size_t first = group.make_room(objects.size());
  const auto each = [&](std::size_t piece, const auto& work) {
    const std::size_t end = std::min(objects.size(), (piece + 1) * piece_size);
    for (std::size_t i = piece * piece_size; i < end; i++) work(objects[i], first + i, i);
  };
  std::vector<Piece> pieces((objects.size() + piece_size - 1) / piece_size);
  parallel_for(pieces.size(), options.threads, [&](std::size_t p) {
    Piece& piece = pieces[p];
    each(p, [&](const Object& object, std::size_t index, std::size_t i) {
      const Surface& surface = scene.surfaces[object.surface];
      const Affine m = object.placement == 0 ? outer : outer * scene.placements[object.placement];
      LeafExtent extent{{}, motion + transform_vector(outer, object.motion)};
      Leaf& leaf = group.leaves[index];
      std::visit(LeafMaker{m, leaf, extent}, object.shape);
      leaf.target = object.surface;
      leaf.passage = passage_of(surface, false);
      leaf.order = touch_order(leaf.passage, group.order + static_cast<std::uint32_t>(i));
      const bool is_placed = leaf.placement == needs_placement;
      piece.magnitude =
          std::max(piece.magnitude, group.finish(index, extent, is_placed ? placed_cost : shape_cost, options));
      piece.has_textures |= surface.texture != Texture::none;
      piece.placed += is_placed;
    });
  });
  for (std::size_t p = 0; p < pieces.size(); p++) {
    group.magnitude = std::max(group.magnitude, pieces[p].magnitude);
    world.has_textures |= pieces[p].has_textures;
    if (pieces[p].placed == 0) continue;
    each(p, [&](const Object& object, std::size_t index, std::size_t) {
      Leaf& leaf = group.leaves[index];
      if (leaf.placement != needs_placement) return;
      leaf.placement = add_placement(world, outer * scene.placements[object.placement]);
    });
  }
  group.order += static_cast<std::uint32_t>(objects.size());
  world.shape_count += objects.size();
}

}  // namespace penumbra
