#include "sampling/figures/figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace penumbra {
namespace {

std::vector<PlanePoint> in_order_of_x(std::span<const PlanePoint> points) {
  std::vector<PlanePoint> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const PlanePoint& a, const PlanePoint& b) { return a.x < b.x; });
  return sorted;
}

// Sums over the entries 0..i-1 of a list to which values are added, in O(log n) each (Fenwick 1994).
class PrefixSums {
 public:
  explicit PrefixSums(std::size_t size) : sums_(size + 1) {}

  void add(std::size_t i, double value) {
    for (i++; i < sums_.size(); i += i & -i) sums_[i] += value;
  }
  double before(std::size_t i) const {
    double sum = 0;
    for (; i > 0; i -= i & -i) sum += sums_[i];
    return sum;
  }

 private:
  std::vector<double> sums_;
};

// The double sum of Warnock's formula. In order of x, the later point of a pair has the larger x; sums in order of y
// account for the larger y.
double sum_over_pairs(std::span<const PlanePoint> points) {
  const std::vector<PlanePoint> sorted = in_order_of_x(points);
  std::vector<double> heights;
  heights.reserve(sorted.size());
  for (const PlanePoint& p : sorted) heights.push_back(p.y);
  std::sort(heights.begin(), heights.end());
  PrefixSums counts(heights.size()), gaps(heights.size());
  double sum = 0, all_gaps = 0;
  for (const PlanePoint& p : sorted) {
    const auto rank = static_cast<std::size_t>(std::lower_bound(heights.begin(), heights.end(), p.y) - heights.begin());
    const double gap = 1 - p.y;
    const double earlier = counts.before(rank) * gap + (all_gaps - gaps.before(rank));
    sum += (1 - p.x) * (2 * earlier + gap);
    counts.add(rank, 1);
    gaps.add(rank, gap);
    all_gaps += gap;
  }
  return sum;
}

}  // namespace

double l2_star_discrepancy(std::span<const PlanePoint> points) {
  const auto n = static_cast<double>(points.size());
  double single = 0;
  for (const PlanePoint& p : points) single += (1 - p.x * p.x) * (1 - p.y * p.y);
  return std::sqrt(std::max(1.0 / 9 - single / (2 * n) + sum_over_pairs(points) / (n * n), 0.0));
}

double star_discrepancy(std::span<const PlanePoint> points) {
  const std::vector<PlanePoint> sorted = in_order_of_x(points);
  const double share = 1 / static_cast<double>(sorted.size());
  std::vector<double> heights = {0, 1};  // of the first l points, with the ends 0 and 1
  double largest = 0;
  for (std::size_t l = 0; l <= sorted.size(); l++) {
    const double left = l == 0 ? 0 : sorted[l - 1].x;
    const double right = l == sorted.size() ? 1 : sorted[l].x;
    for (std::size_t k = 0; k + 1 < heights.size(); k++) {
      const double inside = static_cast<double>(k) * share;
      largest = std::max({largest, inside - left * heights[k], right * heights[k + 1] - inside});
    }
    if (l == sorted.size()) break;
    const double y = sorted[l].y;
    heights.insert(std::upper_bound(heights.begin(), heights.end() - 1, y), y);
  }
  return largest;
}

}  // namespace penumbra
