// Counts of points in cells of equal area. The lecture on jittered samples says that they "may leave large areas
// uncovered" and "may have some areas with more samples than necessary": see the emptiest and the fullest cell.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "sampling/figures/plane_point.hpp"

namespace penumbra {

// n cells of area 1/n: round(sqrt(n)) rows; the first n % rows of them have one cell more than the others and are
// proportionally higher. For a square number of points this is the grid of squares.
class EqualCells {
 public:
  explicit EqualCells(std::size_t n);

  std::size_t size() const { return n_; }
  std::size_t rows() const { return rows_; }
  std::size_t first_of_row(std::size_t row) const { return row * columns_ + std::min(row, long_rows_); }
  std::size_t columns(std::size_t row) const { return first_of_row(row + 1) - first_of_row(row); }
  // Where a row begins; the last one ends at 1.
  double top_of_row(std::size_t row) const { return static_cast<double>(first_of_row(row)) / static_cast<double>(n_); }
  std::size_t cell_of(const PlanePoint& point) const;

 private:
  std::size_t n_, rows_;
  std::size_t columns_;    // of a short row
  std::size_t long_rows_;  // rows with one cell more
};

struct CellCounts {
  int fullest = 0, emptiest = 0;  // points in them
  int empty = 0;                  // cells without a point
};

// Counts n points in n equal cells.
CellCounts count_in_cells(std::span<const PlanePoint> points);

// Counts n numbers of [0, 1) in n equal intervals.
CellCounts count_in_intervals(std::span<const double> values);

}  // namespace penumbra
