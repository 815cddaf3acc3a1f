// The figures of a sample pattern that are numbers; its spectrum is in spectrum.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace penumbra {

// A point of the unit square, in double precision.
struct PlanePoint {
  double x = 0, y = 0;  // in [0, 1)
};

// Counts of points in cells of equal area. The lecture on jittered samples says that they "may leave large areas
// uncovered" and "may have some areas with more samples than necessary": see the emptiest and the fullest cell.

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

// Star discrepancies of points in the unit square: how much the fraction of the points in a box [0, x) x [0, y) differs
// from the area of the box. After Warnock, "Computational investigations of low-discrepancy point sets" (1972), and
// Bundschuh and Zhu, "A method for exact calculation of the discrepancy of low-dimensional finite point sets" (1993).

// The root of the mean square over all boxes (Warnock's formula for two dimensions, exact):
//   T^2 = 1/9 - 1/(2n) sum_i (1 - x_i^2)(1 - y_i^2) + 1/n^2 sum_ij (1 - max(x_i, x_j))(1 - max(y_i, y_j)).
// n independent random points have T^2 = 5/(36 n) on average. Takes O(n log n).
double l2_star_discrepancy(std::span<const PlanePoint> points);

// The largest over all boxes, exact: only boxes whose upper sides pass through points or end at 1 matter. With the
// points in order of x, and the first l of them in order of y (0 in front, 1 behind),
//   D = max over l, k of |k/n - x_l y_k| and |k/n - x_{l+1} y_{k+1}|.
// Takes O(n^2).
double star_discrepancy(std::span<const PlanePoint> points);

// How evenly points are spread over the unit square with opposite edges joined (a torus, because the pattern of a pixel
// meets similar ones there): the smallest distance between two points, and the largest circle that contains none, both
// exact but for rounding. The best arrangement of n points is the hexagonal lattice, with cells of area 1/n.

struct ClosestPair {
  double distance = 0;
  std::size_t a = 0, b = 0;
};

// The two closest points on the torus; a single point has distance 1, that to its own copies.
ClosestPair closest_pair(std::span<const PlanePoint> points);

struct EmptyCircle {
  double radius = 0;
  PlanePoint centre;
};

// The largest circle on the torus with no point inside. Its centre is a corner of a Voronoi cell: each cell is cut out
// of the square around its point by the bisectors to all points that are near enough to matter.
EmptyCircle largest_empty_circle(std::span<const PlanePoint> points);

// The smallest distance of n points on the torus is at most sqrt(2 / (sqrt(3) n)), that of the densest packing.
double largest_possible_distance(std::size_t n);

// The largest empty circle of n points on the torus has at least the radius sqrt(2 / (3 sqrt(3) n)), that of the
// thinnest covering (Kershner 1939).
double smallest_possible_circle(std::size_t n);

// Measures how fast the error of a mean over n sample points falls with n: the slope of the logarithm of the variance
// against the logarithm of n. It is -1 for random points. For jittered points it is -2 for smooth functions and -1.5
// for edges (Mitchell, "Consequences of stratified sampling in graphics", 1996).

struct Convergence {
  double smooth = 0;  // slope for exp(-x^2 - y^2)
  double edges = 0;   // slope for the mean variance over 50 random half-planes
};

// The pattern's points for `count` samples, in its realization number `replicate`.
using PatternSource = std::function<std::vector<PlanePoint>(std::size_t count, int replicate)>;

// Fits the least-squares line through 16, 32, ..., 1024 points. The variance is the mean squared difference from the
// true integral over `replicates` realizations, so it includes the bias of a biased pattern.
Convergence measure_convergence(const PatternSource& source, int replicates);

// The points with a x + b y <= c.
struct HalfPlane {
  double a, b, c;
};

// The area of the part of the unit square inside the half-plane; neither a nor b may be 0.
double area_in_unit_square(HalfPlane half_plane);

}  // namespace penumbra
