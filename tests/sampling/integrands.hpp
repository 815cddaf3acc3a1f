// Functions of the unit square with known means, for which sample points are used. Smooth ones are bumps; edges are
// half-planes that cross the square, as the outlines of shapes cross a pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace penumbra::test {

// 1 / (1 + ((u - x)^2 + (v - y)^2) / width^2)^2: smooth, not periodic, and not a sum of a function of u and one of v.
struct Bump {
  float x, y, width;

  float operator()(float u, float v) const {
    const float scale = 1 / (width * width);
    const float t = 1 + ((u - x) * (u - x) + (v - y) * (v - y)) * scale;
    return 1 / (t * t);
  }

  // Simpson's rule: its error is far below that of the sample points.
  double mean() const {
    constexpr int steps = 256;
    const auto weight = [](int i) { return i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0; };
    double sum = 0;
    for (int i = 0; i <= steps; i++) {
      for (int k = 0; k <= steps; k++) {
        const double u = i / double{steps} - x, v = k / double{steps} - y;
        const double t = 1 + (u * u + v * v) / (double{width} * width);
        sum += weight(i) * weight(k) / (t * t);
      }
    }
    return sum / (9.0 * steps * steps);
  }
};

// 1 where cosine * u + sine * v < offset, else 0.
struct Edge {
  float cosine, sine, offset;

  float operator()(float u, float v) const { return cosine * u + sine * v < offset ? 1.0f : 0.0f; }

  double mean() const {
    constexpr int steps = 1 << 16;  // columns; the length below is linear in all but the few with a corner
    double sum = 0;
    for (int i = 0; i < steps; i++) {
      const double end = (offset - cosine * (i + 0.5) / steps) / sine;
      sum += sine > 0 ? std::clamp(end, 0.0, 1.0) : 1 - std::clamp(end, 0.0, 1.0);
    }
    return sum / steps;
  }
};

inline std::vector<Bump> random_bumps(int count) {
  std::mt19937 random(11);
  const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  std::vector<Bump> list;
  for (int i = 0; i < count; i++) list.push_back({number(), number(), 0.4f + 0.6f * number()});
  return list;
}

// In all directions, at most 0.8 of the way from the middle to the farthest corner: both parts of the square count.
inline std::vector<Edge> random_edges(int count) {
  std::mt19937 random(12);
  const auto number = [&] { return static_cast<double>(random() >> 8) * 0x1p-24; };
  std::vector<Edge> list;
  for (int i = 0; i < count; i++) {
    const double angle = 2 * std::numbers::pi * number();
    const double c = std::cos(angle), s = std::sin(angle);
    const double reach = (std::abs(c) + std::abs(s)) / 2;
    const double offset = (c + s) / 2 + 0.8 * reach * (2 * number() - 1);
    list.push_back({static_cast<float>(c), static_cast<float>(s), static_cast<float>(offset)});
  }
  return list;
}

}  // namespace penumbra::test
