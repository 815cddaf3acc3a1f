#include "geometry/shape_leaves.hpp"

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

struct ShapeLeaf {
  Leaf leaf;
  LeafExtent extent;
  std::uint32_t cost;
};

// A shape that the map keeps of its kind is traced as what it becomes, others behind a placement.
template <AnalyticShape Shape>
ShapeLeaf leaf_of_shape(const Shape& shape, const Affine& m) {
  if (const std::optional<Shape> moved = mapped(m, shape)) {
    return {Leaf(leaf_of(*moved)), {bounds_of(*moved), {}}, shape_cost};
  }
  ShapeLeaf placed{Leaf(leaf_of(shape)), {transformed_bounds(m, shape), {}}, placed_cost};
  placed.leaf.placement = needs_placement;
  placed.extent.reach = row_sum(m) * magnitude(bounds_of(shape)) + max_component(abs(m.translation));
  return placed;
}

ShapeLeaf leaf_of_object(const Object& object, const Affine& m) {
  const auto make = [&]<typename Kind>(const Kind& shape) -> ShapeLeaf {
    if constexpr (AnalyticShape<Kind>) return leaf_of_shape(shape, m);
    __builtin_unreachable();
  };
  return std::visit(make, object.shape);
}

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
      ShapeLeaf made = leaf_of_object(object, outer * scene.placements[object.placement]);
      made.leaf.target = object.surface;
      made.leaf.passage = passage_of(surface, false);
      made.leaf.order = touch_order(made.leaf.passage, group.order + static_cast<std::uint32_t>(i));
      made.extent.motion = motion + transform_vector(outer, object.motion);
      piece.magnitude = std::max(piece.magnitude, group.store(index, made.leaf, made.extent, made.cost, options));
      piece.has_textures |= surface.texture != Texture::none;
      piece.placed += made.leaf.placement == needs_placement;
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
