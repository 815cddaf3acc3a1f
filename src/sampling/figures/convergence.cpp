#include "sampling/figures/figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

constexpr int half_plane_count = 50;

struct Edge {
  HalfPlane half_plane;
  double area;
};

// Edges through uniform points of the square in uniform directions, the same ones every time.
std::vector<Edge> random_edges() {
  std::mt19937 bits(1);
  const auto fraction = [&bits] { return (static_cast<double>(bits()) + 0.5) * 0x1p-32; };
  std::vector<Edge> edges;
  for (int i = 0; i < half_plane_count; i++) {
    const double angle = 2 * std::numbers::pi * fraction();
    const double a = std::cos(angle), b = std::sin(angle);
    const double x = fraction(), y = fraction();
    const HalfPlane half_plane{a, b, a * x + b * y};
    edges.push_back({half_plane, area_in_unit_square(half_plane)});
  }
  return edges;
}

double smooth_error(const std::vector<PlanePoint>& points) {
  const double side = std::sqrt(std::numbers::pi) / 2 * std::erf(1.0);
  double sum = 0;
  for (const PlanePoint& p : points) sum += std::exp(-p.x * p.x - p.y * p.y);
  return sum / static_cast<double>(points.size()) - side * side;
}

double edge_error(const std::vector<PlanePoint>& points, const Edge& edge) {
  const auto [a, b, c] = edge.half_plane;
  std::size_t inside = 0;
  for (const PlanePoint& p : points) inside += a * p.x + b * p.y <= c ? 1 : 0;
  return static_cast<double>(inside) / static_cast<double>(points.size()) - edge.area;
}

// Slope of the least-squares line through (0, y[0]), (1, y[1]), ...
double slope(const std::vector<double>& y) {
  const double middle = (static_cast<double>(y.size()) - 1) / 2;
  double xy = 0, xx = 0;
  for (std::size_t i = 0; i < y.size(); i++) {
    const double x = static_cast<double>(i) - middle;
    xy += x * y[i];
    xx += x * x;
  }
  return xy / xx;
}

}  // namespace

double area_in_unit_square(HalfPlane half_plane) {
  auto [a, b, c] = half_plane;
  // Mirrored until both coefficients are positive.
  if (a < 0) {
    c -= a;
    a = -a;
  }
  if (b < 0) {
    c -= b;
    b = -b;
  }
  // The triangle below the edge in the quadrant, less the parts beyond x = 1 and y = 1, plus the part beyond both.
  const auto square = [](double x) { return x > 0 ? x * x : 0.0; };
  return (square(c) - square(c - a) - square(c - b) + square(c - a - b)) / (2 * a * b);
}

Convergence measure_convergence(const PatternSource& source, int replicates) {
  const std::vector<Edge> edges = random_edges();
  std::vector<double> smooth, edgy;
  for (std::size_t count = 16; count <= 1024; count *= 2) {
    double smooth_sum = 0, edge_sum = 0;
    for (int replicate = 0; replicate < replicates; replicate++) {
      const std::vector<PlanePoint> points = source(count, replicate);
      const double error = smooth_error(points);
      smooth_sum += error * error;
      for (const Edge& edge : edges) {
        const double e = edge_error(points, edge);
        edge_sum += e * e;
      }
    }
    // An error of exactly 0 has no logarithm.
    smooth.push_back(std::log2(std::max(smooth_sum / replicates, 1e-300)));
    edgy.push_back(std::log2(std::max(edge_sum / replicates / half_plane_count, 1e-300)));
  }
  return {slope(smooth), slope(edgy)};
}

}  // namespace penumbra
