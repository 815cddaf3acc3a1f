// The cells are equal, cover the square, and are counted correctly.

#include <gtest/gtest.h>

#include "figures/plane_points.hpp"
#include "sampling/figures/figures.hpp"

namespace penumbra::test {
namespace {

TEST(Cells, HaveEqualAreas) {
  for (std::size_t n = 1; n <= 300; n++) {
    const EqualCells cells(n);
    EXPECT_EQ(cells.first_of_row(0), 0u);
    EXPECT_EQ(cells.first_of_row(cells.rows()), n);
    for (std::size_t row = 0; row < cells.rows(); row++) {
      const double height = cells.top_of_row(row + 1) - cells.top_of_row(row);
      EXPECT_NEAR(height / static_cast<double>(cells.columns(row)), 1 / static_cast<double>(n), 1e-12);
      // As square as a whole number of rows allows.
      EXPECT_LE(height * static_cast<double>(cells.columns(row)), 2 + 1e-12);
      EXPECT_GE(height * static_cast<double>(cells.columns(row)), 1.0 / 3 - 1e-12);
    }
  }
}

// A cell's middle, and points just inside its corners, are in it.
TEST(Cells, AreWhereTheySay) {
  for (std::size_t n = 1; n <= 100; n++) {
    const EqualCells cells(n);
    for (std::size_t row = 0; row < cells.rows(); row++) {
      for (std::size_t column = 0; column < cells.columns(row); column++) {
        for (const double part : {1e-6, 0.5, 1 - 1e-6}) {
          const double height = cells.top_of_row(row + 1) - cells.top_of_row(row);
          const PlanePoint p{(static_cast<double>(column) + part) / static_cast<double>(cells.columns(row)),
                             cells.top_of_row(row) + part * height};
          ASSERT_EQ(cells.cell_of(p), cells.first_of_row(row) + column) << n;
        }
      }
    }
  }
}

TEST(Cells, OfARegularGridHoldOneEach) {
  const CellCounts counts = count_in_cells(regular_grid(8));
  EXPECT_EQ(counts.fullest, 1);
  EXPECT_EQ(counts.emptiest, 1);
  EXPECT_EQ(counts.empty, 0);
}

TEST(Cells, OfAHandMadeSet) {
  // 2 x 2 cells with 3, 1, 0, 0 points.
  const std::vector<PlanePoint> points = {{0.1, 0.1}, {0.2, 0.3}, {0.49, 0.49}, {0.5, 0.1}};
  const CellCounts counts = count_in_cells(points);
  EXPECT_EQ(counts.fullest, 3);
  EXPECT_EQ(counts.emptiest, 0);
  EXPECT_EQ(counts.empty, 2);
  const std::vector<double> values = {0.1, 0.24, 0.25, 0.999};
  const CellCounts intervals = count_in_intervals(values);
  EXPECT_EQ(intervals.fullest, 2);
  EXPECT_EQ(intervals.emptiest, 0);
  EXPECT_EQ(intervals.empty, 1);
}

}  // namespace
}  // namespace penumbra::test
