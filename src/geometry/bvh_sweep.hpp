// Subtrees over few items: at every level all splits along the three axes are compared by the surface area heuristic
// (MacDonald and Booth 1990). The items are sorted once; splits keep the three orders (Wald and Havran 2006).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/bvh_subtree.hpp"

namespace penumbra {

class SweepTree {
 public:
  // More are better split between bins: hardly another tree, in less time.
  static constexpr std::size_t most_items = 48;

  // The items are those from `begin` on in the group.
  SweepTree(std::span<const BvhItem> items, std::uint32_t begin, BvhOutput& output);
  NodeReference build(int depth, const FloatBounds& bounds) { return build(0, count_, 0, depth, bounds); }

 private:
  struct Split {
    float cost;
    int axis;
    std::uint32_t position;  // items before it go left
  };

  // `along`: an axis in whose order the items of the range follow each other.
  NodeReference build(std::uint32_t begin, std::uint32_t end, int along, int depth, const FloatBounds& bounds);
  Split best_split(std::uint32_t begin, std::uint32_t end, const FloatBounds& bounds) const;
  FloatBounds bounds_of(int axis, std::uint32_t begin, std::uint32_t end) const;
  void divide(std::uint32_t begin, std::uint32_t middle, std::uint32_t end, int axis);
  NodeReference leaf(std::uint32_t begin, std::uint32_t end, int along);

  std::span<const BvhItem> items_;
  std::uint32_t begin_, count_;
  BvhOutput& output_;
  std::array<FloatBounds, most_items> bounds_;
  std::array<float, most_items> cost_;
  std::array<std::array<std::uint8_t, most_items>, 3> sorted_;  // the items in the order of their centres along an axis
};

}  // namespace penumbra
