#include "geometry/bvh.hpp"

#include <algorithm>
#include <array>
#include <cfloat>

namespace penumbra {
namespace {

constexpr double node_cost = 1.0;
constexpr double cost_of_few = 4;  // up to here a tree costs more than it saves
constexpr std::size_t sweep_limit = 512;
constexpr int bin_count = 32;
constexpr int balanced_below_depth = 36;  // from here on halves, so that 2^24 items still end above depth 60
constexpr std::uint32_t largest_run = 8;

double center(const BvhItem& item, int axis) { return item.bounds.lo[axis] + item.bounds.hi[axis]; }

// The order of the items along an axis; the index makes it total, so that every machine builds the same tree.
auto less_along(int axis) {
  return [axis](const BvhItem& a, const BvhItem& b) {
    const double ca = center(a, axis);
    const double cb = center(b, axis);
    return ca != cb ? ca < cb : a.leaf < b.leaf;
  };
}

Bounds bounds_of(std::span<const BvhItem> items) {
  Bounds b;
  for (const BvhItem& item : items) b = include(b, item.bounds);
  return b;
}

struct Split {
  double cost = 0;
  int axis = -1;             // none
  std::size_t position = 0;  // items before it go left, once they are sorted or partitioned along the axis
  double plane = 0;          // of a binned split: centres (doubled) below it go left
};

Split best_sweep(std::span<BvhItem> items, Split best) {
  std::vector<double> right(items.size() + 1);
  for (int axis = 0; axis < 3; axis++) {
    std::sort(items.begin(), items.end(), less_along(axis));
    Bounds b;
    double cost = 0;
    for (std::size_t i = items.size(); i-- > 1;) {
      b = include(b, items[i].bounds);
      cost += items[i].cost;
      right[i] = half_area(b) * cost;
    }
    b = {};
    cost = 0;
    for (std::size_t i = 1; i < items.size(); i++) {
      b = include(b, items[i - 1].bounds);
      cost += items[i - 1].cost;
      const double total = half_area(b) * cost + right[i];
      if (total < best.cost) best = {total, axis, i, 0};
    }
  }
  return best;
}

Split best_binned(std::span<const BvhItem> items, Split best) {
  struct Bin {
    Bounds bounds;
    double cost = 0;
  };
  for (int axis = 0; axis < 3; axis++) {
    double lo = DBL_MAX;
    double hi = -DBL_MAX;
    for (const BvhItem& item : items) {
      lo = std::min(lo, center(item, axis));
      hi = std::max(hi, center(item, axis));
    }
    if (!(lo < hi)) continue;
    const double scale = bin_count / (hi - lo);
    std::array<Bin, bin_count> bins;
    for (const BvhItem& item : items) {
      Bin& bin = bins[std::min(bin_count - 1, static_cast<int>((center(item, axis) - lo) * scale))];
      bin.bounds = include(bin.bounds, item.bounds);
      bin.cost += item.cost;
    }
    std::array<double, bin_count> right{};
    Bin sum;
    for (int i = bin_count - 1; i > 0; i--) {
      sum = {include(sum.bounds, bins[i].bounds), sum.cost + bins[i].cost};
      right[i] = half_area(sum.bounds) * sum.cost;
    }
    sum = {};
    for (int i = 1; i < bin_count; i++) {
      sum = {include(sum.bounds, bins[i - 1].bounds), sum.cost + bins[i - 1].cost};
      const double total = half_area(sum.bounds) * sum.cost + right[i];
      if (total < best.cost) best = {total, axis, 0, lo + i / scale};
    }
  }
  return best;
}

void store_bounds(const Bounds& b, float (&out)[6]) {
  for (int axis = 0; axis < 3; axis++) {
    const auto lo = static_cast<float>(b.lo[axis]);
    const auto hi = static_cast<float>(b.hi[axis]);
    out[axis] = lo > b.lo[axis] ? std::nextafter(lo, -FLT_MAX) : lo;
    out[3 + axis] = hi < b.hi[axis] ? std::nextafter(hi, FLT_MAX) : hi;
  }
}

struct Builder {
  std::span<BvhItem> items;
  std::uint32_t first_leaf;
  ZeroedVector<Node>& nodes;

  NodeReference build(std::size_t begin, std::size_t end, int depth) {
    const std::span<BvhItem> part = items.subspan(begin, end - begin);
    const auto count = static_cast<std::uint32_t>(part.size());
    double leaf_cost = 0;
    for (const BvhItem& item : part) leaf_cost += item.cost;
    if (count <= 1 || (depth == 0 && leaf_cost <= cost_of_few)) {
      return leaf_reference(first_leaf + static_cast<std::uint32_t>(begin), count);
    }

    const double area = half_area(bounds_of(part));
    Split split;
    split.cost = count <= largest_run ? area * leaf_cost - area * node_cost : DBL_MAX;
    if (depth < balanced_below_depth) {
      split = part.size() <= sweep_limit ? best_sweep(part, split) : best_binned(part, split);
    }
    if (split.axis < 0 && count <= largest_run) {
      return leaf_reference(first_leaf + static_cast<std::uint32_t>(begin), count);
    }
    const std::size_t middle = begin + divide(part, split);

    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.emplace_back();
    const NodeReference left = build(begin, middle, depth + 1);
    const NodeReference right = build(middle, end, depth + 1);
    Node& node = nodes[index];
    store_bounds(bounds_of(items.subspan(begin, middle - begin)), node.bounds[0]);
    store_bounds(bounds_of(items.subspan(middle, end - middle)), node.bounds[1]);
    node.child[0] = left;
    node.child[1] = right;
    return index;
  }

  // Brings the items of the left side to the front and tells how many there are: at least one on each side.
  static std::size_t divide(std::span<BvhItem> part, const Split& split) {
    if (split.axis >= 0 && split.position > 0) {
      std::sort(part.begin(), part.end(), less_along(split.axis));
      return split.position;
    }
    if (split.axis >= 0) {
      const auto right = std::partition(part.begin(), part.end(),
                                        [&](const BvhItem& item) { return center(item, split.axis) < split.plane; });
      if (right != part.begin() && right != part.end()) return static_cast<std::size_t>(right - part.begin());
    }
    const Bounds b = bounds_of(part);
    const Vec3 extent = b.hi - b.lo;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto half = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
    std::nth_element(part.begin(), half, part.end(), less_along(axis));
    return part.size() / 2;
  }
};

}  // namespace

NodeReference build_bvh(std::span<BvhItem> items, std::uint32_t first_leaf, ZeroedVector<Node>& nodes) {
  return Builder{items, first_leaf, nodes}.build(0, items.size(), 0);
}

}  // namespace penumbra
