// Darts are thrown with a distance somewhat too large for the count: each is kept unless it is nearer than that to an
// earlier one. Then the place farthest from all points is added, again and again. Each such place is no farther than
// the one before, so the distance of the last is the least of all, and no place is farther than it: the set is maximal.
// The farthest place is a corner of a Voronoi cell; the cells are kept as polygons and cut by every new point.
#include "sampling/sample_tables.hpp"

#include <algorithm>
#include <cmath>

#include "base/hash.hpp"

namespace penumbra {
namespace {

// Coordinates and their differences are multiples of 2^-24: their squares and sums of squares are exact.
constexpr double steps = 16777216;

struct Place {
  double x, y;
};

double norm2(Place p) { return p.x * p.x + p.y * p.y; }

// The coordinate in [0, 1), on the grid.
double wrap(double x) {
  const double rounded = std::floor(x * steps + 0.5) / steps;
  return rounded - std::floor(rounded);
}

// The shortest signed distance on the circle between two coordinates that differ by x, -1 < x < 1.
double turn(double x) { return x - (static_cast<int>(x + 1.5) - 1); }
Place way(Place a, Place b) { return {turn(b.x - a.x), turn(b.y - a.y)}; }

// A Voronoi cell: all places nearer to a point than to any other, as a convex polygon around it.
class Cell {
 public:
  // The cell of a single point on the torus, whose neighbours are its own images.
  Cell() : corners_{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}} { measure(); }

  // Removes the places nearer to the point at `offset`.
  void cut(Place offset) {
    const double half = 0.5 * norm2(offset);
    const auto outside = [&](Place p) { return p.x * offset.x + p.y * offset.y - half; };
    kept_.clear();
    Place a = corners_.back();
    double out_a = outside(a);
    for (const Place b : corners_) {
      const double out_b = outside(b);
      if ((out_a < 0 && out_b > 0) || (out_a > 0 && out_b < 0)) {
        const double t = out_a / (out_a - out_b);
        kept_.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
      if (out_b <= 0) kept_.push_back(b);
      a = b;
      out_a = out_b;
    }
    corners_.swap(kept_);
    measure();
  }

  // The corner farthest from the point, and the square of its distance.
  Place farthest() const { return farthest_; }
  double radius2() const { return radius2_; }

 private:
  void measure() {
    radius2_ = 0;
    for (const Place p : corners_) {
      if (norm2(p) > radius2_) {
        radius2_ = norm2(p);
        farthest_ = p;
      }
    }
  }

  std::vector<Place> corners_, kept_;
  Place farthest_{};
  double radius2_ = 0;
};

// Points on the torus with their Voronoi cells.
class Cells {
 public:
  void add(Place point) {
    Cell own;
    ways_.clear();
    for (const Place p : points_) ways_.push_back(way(point, p));
    // Near points first, so that most of the others are soon out of reach.
    const double near2 = 4 / static_cast<double>(points_.size() + 1);
    for (const Place to : ways_) {
      if (norm2(to) < near2) cut(own, to);
    }
    for (std::size_t i = 0; i < points_.size(); i++) {
      const Place to = ways_[i];
      const double distance2 = norm2(to);
      least2_ = std::min(least2_, distance2);
      if (distance2 >= near2) cut(own, to);
      if (distance2 < 4 * radius2_[i] || radius2_[i] >= large2) {
        cut(cells_[i], {-to.x, -to.y});
        radius2_[i] = cells_[i].radius2();
      }
    }
    points_.push_back(point);
    radius2_.push_back(own.radius2());
    cells_.push_back(std::move(own));
  }

  void add_farthest() {
    const std::size_t i = farthest();
    const Place corner = cells_[i].farthest();
    add({wrap(points_[i].x + corner.x), wrap(points_[i].y + corner.y)});
  }

  std::size_t size() const { return points_.size(); }
  const std::vector<Place>& points() const { return points_; }
  double least2() const { return least2_; }  // the squared distance of the nearest two; 1 for a point and its image
  double greatest2() const { return radius2_[farthest()]; }  // the greatest from a place to its nearest point

 private:
  static constexpr double large2 = 0.0625;  // a smaller cell is cut only by points less than half the torus away

  std::size_t farthest() const {
    return static_cast<std::size_t>(std::max_element(radius2_.begin(), radius2_.end()) - radius2_.begin());
  }

  // Cuts by the point at `offset` and, where the cell is large, by its images. A point at least twice as far as the
  // farthest corner cuts nothing.
  static void cut(Cell& cell, Place offset) {
    if (cell.radius2() < large2) {
      if (norm2(offset) < 4 * cell.radius2()) cell.cut(offset);
      return;
    }
    for (int dy = -1; dy <= 1; dy++) {
      for (int dx = -1; dx <= 1; dx++) {
        const Place image{offset.x + dx, offset.y + dy};
        if (norm2(image) < 4 * cell.radius2()) cell.cut(image);
      }
    }
  }

  std::vector<Place> points_, ways_;
  std::vector<Cell> cells_;
  std::vector<double> radius2_;  // of each cell
  double least2_ = 1;
};

// Throws `throws` darts and returns up to `most` points, no two of them nearer than `distance`.
std::vector<Place> throw_darts(double distance, std::size_t most, std::uint32_t throws, std::uint32_t seed) {
  const int side = std::max(1, static_cast<int>(1 / distance));  // buckets at least as wide as the distance
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> first(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), none), next;
  std::vector<Place> points;
  const auto is_free = [&](Place p, int bucket) {
    for (std::uint32_t i = first[static_cast<std::size_t>(bucket)]; i != none; i = next[i]) {
      if (norm2(way(p, points[i])) < distance * distance) return false;
    }
    return true;
  };
  const auto is_free_around = [&](Place p, int column, int row) {
    for (int dy = side - 1; dy <= side + 1; dy++) {
      for (int dx = side - 1; dx <= side + 1; dx++) {
        if (!is_free(p, (row + dy) % side * side + (column + dx) % side)) return false;
      }
    }
    return true;
  };
  for (std::uint32_t i = 0; i < throws && points.size() < most; i++) {
    const Place p{(hash(seed, 2 * i) >> 8) / steps, (hash(seed, 2 * i + 1) >> 8) / steps};
    const int column = static_cast<int>(p.x * side), row = static_cast<int>(p.y * side);
    if (!is_free_around(p, column, row)) continue;
    std::uint32_t& head =
        first[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) + static_cast<std::size_t>(column)];
    next.push_back(head);
    head = static_cast<std::uint32_t>(points.size());
    points.push_back(p);
  }
  return points;
}

// A tile of `size` points. Darts at nearly the final distance leave most of the set to chance; where so many find room
// that the last points cannot make the set maximal, they are thrown again at a larger distance, in the end only one.
Cells make_tile(std::uint32_t size, std::uint32_t seed) {
  constexpr int attempts = 64;
  double distance = 0.87 / std::sqrt(static_cast<double>(size));
  for (int attempt = 0; attempt < attempts; attempt++, distance *= 1.01) {
    const bool last = attempt + 1 == attempts;
    Cells cells;
    const std::uint32_t throws = last ? 1 : 20 * size;
    for (const Place p : throw_darts(distance, size, throws, hash(seed, static_cast<std::uint32_t>(attempt)))) {
      cells.add(p);
    }
    while (cells.size() < size) cells.add_farthest();
    // A margin, so that rounding in code that uses or checks the points cannot matter.
    if (last || cells.greatest2() < cells.least2() * 0.9999) return cells;
  }
  return {};
}

}  // namespace

PoissonTable make_poisson_table(std::uint32_t count, std::uint32_t seed) {
  PoissonTable table;
  table.count = std::max(count, 1u);
  while (std::uint64_t{table.tiles} * table.tiles * largest_poisson_tile < table.count) table.tiles++;
  const std::uint32_t tile_count = table.tiles * table.tiles;
  table.size = table.count / tile_count + (table.count % tile_count != 0 ? 1 : 0);
  const Cells cells = make_tile(table.size, seed);
  const double distance = std::sqrt(cells.least2()) / table.tiles;
  table.distance = static_cast<float>(distance);
  if (table.distance > distance) table.distance = std::nextafter(table.distance, 0.0f);
  for (const Place p : cells.points()) {
    table.u.push_back(static_cast<float>(p.x));
    table.v.push_back(static_cast<float>(p.y));
  }
  return table;
}

}  // namespace penumbra
