#include "geometry/bvh_sweep.hpp"

#include <algorithm>
#include <bit>

namespace penumbra {
namespace {

constexpr std::uint32_t largest_run = 8;  // of leaves below a node
constexpr float node_cost = 1;            // of looking at a node, in tests of a sphere
static_assert(largest_run <= max_leaves_in_node && SweepTree::most_items >= largest_run);

// Whole numbers in the order of the numbers.
std::int32_t ordered(float value) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  return bits ^ static_cast<std::int32_t>(static_cast<std::uint32_t>(bits >> 31) >> 1);
}

}  // namespace

SweepTree::SweepTree(std::span<const BvhItem> items, std::uint32_t begin, BvhOutput& output)
    : items_(items), begin_(begin), count_(static_cast<std::uint32_t>(items.size())), output_(output) {
  std::array<std::array<std::int32_t, most_items>, 3> keys;
  for (auto& key : keys) key.fill(std::numeric_limits<std::int32_t>::max());
  for (std::uint32_t i = 0; i < count_; i++) {
    bounds_[i] = items[i].bounds();
    cost_[i] = static_cast<float>(items[i].cost);
    const Float4 center = center_of(bounds_[i]);
    for (int axis = 0; axis < 3; axis++) keys[axis][i] = ordered(center[axis]);
  }
  // So few are sorted fastest by counting for each those before it: nothing has to be predicted. Of equal ones, the
  // first comes first.
  for (int axis = 0; axis < 3; axis++) {
    const std::array<std::int32_t, most_items>& key = keys[axis];
    std::array<bool, most_items> taken{};
    for (std::uint32_t i = 0; i < count_; i++) {
      std::int32_t place = 0;
      for (const std::int32_t other : key) place += other < key[i];
      while (taken[place]) place++;
      taken[place] = true;
      sorted_[axis][place] = static_cast<std::uint8_t>(i);
    }
  }
}

NodeReference SweepTree::build(std::uint32_t begin, std::uint32_t end, int along, int depth,
                               const FloatBounds& bounds) {
  const std::uint32_t count = end - begin;
  if (count <= 1) return leaf(begin, end, along);
  Split split = count == 2 ? Split{0, along, 1} : best_split(begin, end, bounds);
  if (count <= largest_run) {
    const float scale = inverse_extent(bounds);
    float cost = 0;
    for (std::uint32_t i = begin; i < end; i++) cost += cost_[sorted_[along][i]];
    if (count == 2) {
      const int a = sorted_[along][begin], b = sorted_[along][begin + 1];
      split.cost = half_area(bounds_[a], scale) * cost_[a] + half_area(bounds_[b], scale) * cost_[b];
    }
    if (!(split.cost < half_area(bounds, scale) * (cost - node_cost)) || depth >= balanced_below_depth)
      return leaf(begin, end, along);
  }
  if (depth >= balanced_below_depth) {
    split.axis = longest_axis(bounds.hi - bounds.lo);
    split.position = count / 2;
  }
  const std::uint32_t middle = begin + split.position;
  if (count > 2 && std::max(split.position, count - split.position) > 2) divide(begin, middle, end, split.axis);
  const FloatBounds left = bounds_of(split.axis, begin, middle);
  const FloatBounds right = bounds_of(split.axis, middle, end);
  const std::uint32_t index = output_.add(node_with(left, right));
  Node& node = output_.nodes[index];
  node.child[0] = build(begin, middle, split.axis, depth + 1, left);
  node.child[1] = build(middle, end, split.axis, depth + 1, right);
  return output_.first_node + index;
}

SweepTree::Split SweepTree::best_split(std::uint32_t begin, std::uint32_t end, const FloatBounds& all) const {
  const float scale = inverse_extent(all);
  const std::uint32_t count = end - begin;
  std::array<std::array<float, most_items>, 3> left;
  std::array<FloatBounds, 3> bounds{};
  std::array<float, 3> cost{};
  for (std::uint32_t i = 1; i < count; i++) {
    for (int axis = 0; axis < 3; axis++) {
      const int item = sorted_[axis][begin + i - 1];
      bounds[axis].include(bounds_[item]);
      cost[axis] += cost_[item];
      left[axis][i] = half_area(bounds[axis], scale) * cost[axis];
    }
  }
  bounds = {};
  cost = {};
  // Costs are not negative: the bits of a smaller one are a smaller number. Below them stands the place; of equal
  // costs, the one nearest to the middle is taken.
  std::uint64_t best = std::numeric_limits<std::uint64_t>::max();
  for (std::uint32_t i = count; i-- > 1;) {
    const std::uint32_t off_middle = 2 * i > count ? 2 * i - count : count - 2 * i;
    for (int axis = 0; axis < 3; axis++) {
      const int item = sorted_[axis][begin + i];
      bounds[axis].include(bounds_[item]);
      cost[axis] += cost_[item];
      const float total = left[axis][i] + half_area(bounds[axis], scale) * cost[axis];
      const std::uint32_t place = off_middle << 16 | i << 2 | static_cast<std::uint32_t>(axis);
      best = std::min(best, std::uint64_t{std::bit_cast<std::uint32_t>(total)} << 32 | place);
    }
  }
  return {std::bit_cast<float>(static_cast<std::uint32_t>(best >> 32)), static_cast<int>(best & 3),
          static_cast<std::uint32_t>(best & 0xffff) >> 2};
}

FloatBounds SweepTree::bounds_of(int axis, std::uint32_t begin, std::uint32_t end) const {
  FloatBounds bounds;
  for (std::uint32_t i = begin; i < end; i++) bounds.include(bounds_[sorted_[axis][i]]);
  return bounds;
}

void SweepTree::divide(std::uint32_t begin, std::uint32_t middle, std::uint32_t end, int axis) {
  std::array<bool, most_items> is_right;
  for (std::uint32_t i = begin; i < end; i++) is_right[sorted_[axis][i]] = i >= middle;
  for (int other = 0; other < 3; other++) {
    if (other == axis) continue;
    std::array<std::uint8_t, most_items> right;
    std::uint32_t l = begin, r = 0;
    for (std::uint32_t i = begin; i < end; i++) {
      const std::uint8_t item = sorted_[other][i];
      sorted_[other][l] = item;
      right[r] = item;
      l += !is_right[item];
      r += is_right[item];
    }
    std::copy_n(right.begin(), r, sorted_[other].begin() + l);
  }
}

NodeReference SweepTree::leaf(std::uint32_t begin, std::uint32_t end, int along) {
  for (std::uint32_t i = begin; i < end; i++) output_.order[begin_ + i] = items_[sorted_[along][i]].leaf;
  return leaf_reference(output_.first_leaf + begin_ + begin, end - begin);
}

}  // namespace penumbra
