// Whether points are stratified: one in each interval, cell, column, row. Points may be off by the rounding of single
// precision, so they are sorted and compared with their intervals instead of counted.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "sampling/points.hpp"

namespace penumbra::test {

inline constexpr double rounding = 0x1p-22;

// Whether each of as many equal parts of [0, 1) as there are values holds one of them, give or take `slack`.
inline bool one_in_each_part(std::vector<float> values, double slack = rounding) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); i++) {
    const auto k = static_cast<double>(i);
    if (!(values[i] >= k / n - slack && values[i] < (k + 1) / n + slack)) return false;
  }
  return true;
}

// Whether each cell has one point, where the square is cut into rows, the r-th with cells[r] cells and a height that is
// its share of all cells. A point may be off sideways by `slack`.
inline bool one_in_each_cell(const Points& points, const std::vector<std::size_t>& cells, double slack = rounding) {
  std::vector<std::size_t> order(points.u.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points.v[a] < points.v[b]; });
  const auto n = static_cast<double>(order.size());
  std::size_t start = 0;
  for (const std::size_t width : cells) {
    if (start + width > order.size()) return false;
    const double low = static_cast<double>(start) / n, high = static_cast<double>(start + width) / n;
    std::vector<float> row;
    for (std::size_t i = start; i < start + width; i++) {
      const double v = points.v[order[i]];
      if (!(v >= low - rounding && v < high + rounding)) return false;
      row.push_back(points.u[order[i]]);
    }
    if (!one_in_each_part(row, slack)) return false;
    start += width;
  }
  return start == order.size();
}

// The cells of `count` points: about sqrt(count) rows, the first count % rows of them with one cell more.
inline std::vector<std::size_t> rows_of_cells(std::size_t count) {
  const auto rows = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(count))));
  std::vector<std::size_t> cells(rows, count / rows);
  for (std::size_t r = 0; r < count % rows; r++) cells[r]++;
  return cells;
}

// `columns` by `rows` equal cells.
inline bool one_in_each_cell(const Points& points, std::size_t columns, std::size_t rows) {
  return one_in_each_cell(points, std::vector<std::size_t>(rows, columns));
}

// The least and the greatest gap between neighbours on the circle of circumference 1.
struct Gaps {
  double least, greatest;
};
inline Gaps gaps_of(std::vector<float> values) {
  std::sort(values.begin(), values.end());
  Gaps gaps{1, 0};
  for (std::size_t i = 0; i < values.size(); i++) {
    const double next = i + 1 < values.size() ? double{values[i + 1]} : 1 + double{values[0]};
    gaps.least = std::min(gaps.least, next - values[i]);
    gaps.greatest = std::max(gaps.greatest, next - values[i]);
  }
  return gaps;
}

// Whether no gap is below 2/3 or above 4/3 of the mean gap.
inline bool evenly_spaced(const std::vector<float>& values) {
  const auto n = static_cast<double>(values.size());
  const Gaps gaps = gaps_of(values);
  return gaps.least > 2 / (3 * n) - rounding && gaps.greatest < 4 / (3 * n) + rounding;
}

}  // namespace penumbra::test
