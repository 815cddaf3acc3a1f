#include "sampling/figures/figures.hpp"

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

// Which of `count` equal parts of [0, 1) holds x.
std::size_t part_of(double x, std::size_t count) {
  return std::min(static_cast<std::size_t>(std::max(x, 0.0) * static_cast<double>(count)), count - 1);
}

CellCounts summary(const std::vector<int>& counts) {
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  return {*most, *least, static_cast<int>(std::count(counts.begin(), counts.end(), 0))};
}

}  // namespace

EqualCells::EqualCells(std::size_t n)
    : n_(n),
      rows_(static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))))),
      columns_(n / rows_),
      long_rows_(n % rows_) {}

std::size_t EqualCells::cell_of(const PlanePoint& point) const {
  // Rows begin at multiples of 1/n, so the interval of y determines the row.
  const std::size_t interval = part_of(point.y, n_);
  std::size_t row = interval / (columns_ + 1);
  while (first_of_row(row + 1) <= interval) row++;
  return first_of_row(row) + part_of(point.x, columns(row));
}

CellCounts count_in_cells(std::span<const PlanePoint> points) {
  const EqualCells cells(points.size());
  std::vector<int> counts(cells.size());
  for (const PlanePoint& p : points) counts[cells.cell_of(p)]++;
  return summary(counts);
}

CellCounts count_in_intervals(std::span<const double> values) {
  std::vector<int> counts(values.size());
  for (const double x : values) counts[part_of(x, values.size())]++;
  return summary(counts);
}

}  // namespace penumbra
