#include "geometry/group_leaves.hpp"

#include <cfloat>

#include "geometry/maps.hpp"

namespace penumbra {
namespace {

// Whether the numbers of the surface give its points as well as numbers of their size can.
bool is_exact(const Leaf& leaf) {
  if (leaf.placement != no_placement) return false;
  if (leaf.kind == LeafKind::box || (leaf.kind == LeafKind::sphere && leaf.sphere.is_ground)) return true;
  return leaf.kind == LeafKind::triangle &&
         std::ranges::any_of(leaf.triangle.normal, [](float n) { return std::abs(n) == 1; });
}

}  // namespace

double GroupLeaves::finish(std::size_t index, const LeafExtent& extent, std::uint32_t cost,
                           const WorldOptions& options) {
  // Hit points and ray origins carry errors of this share of their largest coordinate, and the bounds become numbers of
  // single precision: they are wider by as much.
  constexpr double bounds_margin = 1.0 / (1 << 20) + 1.0 / (1 << 23);
  Leaf& leaf = leaves[index];
  leaf.moves = extent.motion != Vec3{};
  leaf.place = static_cast<std::uint32_t>(index);
  Bounds bounds = extent.bounds;
  double largest = std::max(penumbra::magnitude(bounds), extent.reach);
  if (leaf.moves) {
    set3(leaf.motion, extent.motion);
    bounds = include(shift(bounds, extent.motion * options.shutter_open),
                     shift(bounds, extent.motion * options.shutter_close));
    largest = std::max(largest, penumbra::magnitude(bounds));
  }
  if (leaf.moves || !is_exact(leaf)) leaf.slack = static_cast<float>(largest * slack_share);
  bounds = grow(bounds, largest * bounds_margin + FLT_TRUE_MIN);
  BvhItem& item = items[index];
  set3(item.lo, bounds.lo);
  set3(item.hi, bounds.hi);
  item.leaf = leaf.place;
  item.cost = cost;
  return largest;
}

std::uint32_t add_placement(World& world, const Affine& m) {
  const Affine inv = inverse(m);
  Placement& p = world.placements.emplace_back();
  for (int row = 0; row < 3; row++) {
    for (int column = 0; column < 3; column++) {
      p.linear[3 * row + column] = static_cast<float>(m.column[column][row]);
      p.inverse[3 * row + column] = static_cast<float>(inv.column[column][row]);
    }
  }
  set3(p.translation, m.translation);
  p.stretch = static_cast<float>(row_sum(m));
  p.shrink = static_cast<float>(row_sum(inv));
  return static_cast<std::uint32_t>(world.placements.size() - 1);
}

}  // namespace penumbra
