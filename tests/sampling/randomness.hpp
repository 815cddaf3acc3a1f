// How far lists of numbers are from independent uniform ones, each measure as a standard normal number: one that
// exceeds normal_limit of the count of all numbers looked at (statistics.hpp) is not due to chance.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sampling/points.hpp"
#include "sampling/statistics.hpp"

namespace penumbra::test {

// Counts in side x side cells. Numbers outside [0, 1) count in the nearest cell.
inline std::vector<int> cell_counts(const std::vector<float>& u, const std::vector<float>& v, int side = 16) {
  const auto cell = [side](float x) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(x * static_cast<float>(side)), 0, side - 1));
  };
  std::vector<int> counts(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (std::size_t i = 0; i < u.size(); i++) counts[cell(u[i]) * static_cast<std::size_t>(side) + cell(v[i])]++;
  return counts;
}

inline double mean_of(const std::vector<float>& a) {
  double sum = 0;
  for (const float v : a) sum += v;
  return sum / static_cast<double>(a.size());
}

// Of one dimension: its mean, and chi-square over 16 and 256 intervals.
inline constexpr double numbers_of_line = 4;
inline double unevenness(const std::vector<float>& u) {
  const double mean = std::abs(mean_of(u) - 0.5) * std::sqrt(12.0 * static_cast<double>(u.size()));
  std::vector<int> fine(256), coarse(16);
  for (const float x : u) {
    const auto cell = static_cast<std::size_t>(std::clamp(static_cast<int>(x * 256), 0, 255));
    fine[cell]++;
    coarse[cell / 16]++;
  }
  return std::max({mean, chi_square_deviation(fine), chi_square_deviation(coarse)});
}

// Of two dimensions: each of them, and chi-square over 4 x 4 and 16 x 16 cells.
inline constexpr double numbers_of_square = 2 * numbers_of_line + 2;
inline double unevenness(const Points& p) {
  return std::max({unevenness(p.u), unevenness(p.v), chi_square_deviation(cell_counts(p.u, p.v, 4)),
                   chi_square_deviation(cell_counts(p.u, p.v, 16))});
}

// Between two lists: their correlation, and chi-square over 16 x 16 cells of pairs.
inline constexpr double numbers_of_dependence = 3;
inline double dependence(const std::vector<float>& a, const std::vector<float>& b) {
  return std::max(std::abs(correlation(a, b)) * std::sqrt(static_cast<double>(a.size())),
                  chi_square_deviation(cell_counts(a, b)));
}

// Between the values of a picture, row by row, and their neighbours dx to the right and dy down.
inline double neighbour_dependence(const std::vector<float>& values, int width, int dx, int dy) {
  const int height = static_cast<int>(values.size()) / width;
  std::vector<float> here, there;
  for (int y = 0; y + dy < height; y++) {
    for (int x = 0; x + dx < width; x++) {
      here.push_back(values[static_cast<std::size_t>(y * width + x)]);
      there.push_back(values[static_cast<std::size_t>((y + dy) * width + x + dx)]);
    }
  }
  return dependence(here, there);
}

}  // namespace penumbra::test
