// Points of textures and the statistics of what is there.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "probes/lane_probes.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {

inline constexpr LaneFunction wood_channels[] = {LaneFunction::wood_red, LaneFunction::wood_green,
                                                 LaneFunction::wood_blue};
inline constexpr LaneFunction stone_channels[] = {LaneFunction::stone_red, LaneFunction::stone_green,
                                                  LaneFunction::stone_blue};

struct Points {
  std::vector<float> x, y, z;

  void add(double px, double py, double pz) {
    x.push_back(static_cast<float>(px));
    y.push_back(static_cast<float>(py));
    z.push_back(static_cast<float>(pz));
  }
  std::size_t size() const { return x.size(); }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

inline std::vector<float> values(LaneFunction function, const Points& p,
                                 const Kernel& kernel = *usable_kernels().back()) {
  std::vector<float> out(p.size());
  probes_of(kernel).evaluate(function, p.x, p.y, p.z, out);
  return out;
}

// Independent points of a cube: from one to the next the textures have nothing in common.
inline Points random_points(int count, double half_side, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-half_side, half_side);
  Points points;
  for (int i = 0; i < count; i++) {
    const double x = place(random), y = place(random);
    points.add(x, y, place(random));
  }
  return points;
}

struct Moments {
  double mean, deviation;
};

inline Moments moments(const std::vector<float>& list) {
  double sum = 0, squares = 0;
  for (const float v : list) sum += v;
  const double mean = sum / static_cast<double>(list.size());
  for (const float v : list) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / static_cast<double>(list.size()))};
}

// Five standard deviations of a share: one right texture in a million fails.
inline double share_tolerance(double share, std::size_t count) {
  return 5 * std::sqrt(share * (1 - share) / static_cast<double>(count));
}

}  // namespace penumbra::test
