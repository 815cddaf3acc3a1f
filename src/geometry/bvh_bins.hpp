// Splits of many items: they are counted in bins along the three axes, and the planes between bins are compared by the
// surface area heuristic (Wald 2007). Only minima, maxima and whole numbers are summed up, so a split does not depend
// on the order of the items, nor on how they were dealt to threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "geometry/bvh_item.hpp"

namespace penumbra {

// Half the surface area of bounds, in units of the square of 1/scale.
inline float half_area(const FloatBounds& b, float scale) {
  const Float4 d = (b.hi - b.lo) * scale;
  return d[0] * (d[1] + d[2]) + d[1] * d[2];
}

// The inverse of the largest extent: areas measured with it neither overflow nor underflow. 0 for a point.
inline float inverse_extent(const FloatBounds& b) {
  const Float4 d = b.hi - b.lo;
  const float inverse = 1 / std::max({d[0], d[1], d[2]});
  return inverse <= std::numeric_limits<float>::max() ? inverse : 0;
}

inline constexpr int bin_count = 32;

// Which bins there are: equal parts of the extent of the centres.
class BinGrid {
 public:
  explicit BinGrid(const FloatBounds& centers) : lo_(centers.lo) {
    const Float4 extent = centers.hi - centers.lo;
    for (int axis = 0; axis < 3; axis++) {
      const float scale = bin_count / extent[axis];
      scale_[axis] = scale <= std::numeric_limits<float>::max() ? scale : 0;  // along a point, all are in the first bin
    }
  }

  // The bins of a centre along the axes. What is not a number is in the first bin.
  Int4 bins_of(Float4 center) const {
    const Float4 place = (center - lo_) * scale_;
    constexpr float last = bin_count - 1;
    return __builtin_convertvector(min(max(place, Float4{}), Float4{last, last, last, last}), Int4);
  }

 private:
  Float4 lo_;
  Float4 scale_{};
};

// A split between two bins along an axis: items in bins before `bin` go left.
struct BinnedSplit {
  int axis = -1;  // none
  int bin = 0;
  FloatBounds left, right;

  bool goes_right(Int4 bins) const { return bins[axis] >= bin; }
};

class Bins {
 public:
  void clear() {
    for (auto& along : bounds_) along.fill(FloatBounds());
    for (auto& along : cost_) along.fill(0);
  }

  void add(std::span<const BvhItem> items, const BinGrid& grid) {
    for (const BvhItem& item : items) {
      const FloatBounds bounds = item.bounds();
      const Int4 bins = grid.bins_of(center_of(bounds));
      for (int axis = 0; axis < 3; axis++) {
        const auto bin = static_cast<std::size_t>(bins[axis]);
        bounds_[axis][bin].include(bounds);
        cost_[axis][bin] += item.cost;
      }
    }
  }
  void add(const Bins& other) {
    for (std::size_t axis = 0; axis < 3; axis++) {
      for (int i = 0; i < bin_count; i++) {
        bounds_[axis][i].include(other.bounds_[axis][i]);
        cost_[axis][i] += other.cost_[axis][i];
      }
    }
  }

  // The split with the lowest cost, areas in units of 1/scale^2. There is none if all centres are in one bin.
  BinnedSplit best_split(float scale) const {
    float best = std::numeric_limits<float>::infinity();
    BinnedSplit split;
    for (int axis = 0; axis < 3; axis++) {
      std::array<float, bin_count> right;
      FloatBounds bounds;
      std::uint32_t cost = 0;
      for (int i = bin_count - 1; i > 0; i--) {
        bounds.include(bounds_[axis][i]);
        cost += cost_[axis][i];
        right[i] = cost > 0 ? half_area(bounds, scale) * static_cast<float>(cost) : FloatBounds::infinity;
      }
      bounds = {};
      cost = 0;
      for (int i = 1; i < bin_count; i++) {
        bounds.include(bounds_[axis][i - 1]);
        cost += cost_[axis][i - 1];
        const float total = half_area(bounds, scale) * static_cast<float>(cost) + right[i];
        if (cost > 0 && total < best) {
          best = total;
          split.axis = axis;
          split.bin = i;
        }
      }
    }
    if (split.axis < 0) return split;
    for (int i = 0; i < bin_count; i++) (i < split.bin ? split.left : split.right).include(bounds_[split.axis][i]);
    return split;
  }

 private:
  std::array<std::array<FloatBounds, bin_count>, 3> bounds_{};
  std::array<std::array<std::uint32_t, bin_count>, 3> cost_{};
};

}  // namespace penumbra
