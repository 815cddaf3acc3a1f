// How fast the geometry of a scene of many spheres is prepared: build_world with one thread and with two, by turns.
// The spheres are small, at random in a cube, as in a cloud of particles.
// Usage: build_bench [SPHERES] [TURNS]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

#include "geometry/world.hpp"

namespace {

using namespace penumbra;

Scene cloud_of_spheres(int count) {
  Scene scene;
  scene.triangles = std::make_shared<TriangleStore>();
  scene.surfaces.emplace_back();
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const double spacing = 1 / std::cbrt(count);
  for (int i = 0; i < count; i++) {
    const Vec3 center{uniform(), uniform(), uniform()};
    scene.root.objects.push_back({Sphere{center, spacing * (0.1 + 0.4 * uniform())}, 0, 0, {}});
  }
  return scene;
}

double seconds_to_build(const Scene& scene, int threads) {
  WorldOptions options;
  options.threads = threads;
  const auto start = std::chrono::steady_clock::now();
  const World world = build_world(scene, options);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  const int turns = argc > 2 ? std::atoi(argv[2]) : 5;
  const Scene scene = cloud_of_spheres(count);
  std::vector<double> one, two, ratios;
  for (int turn = 0; turn < turns; turn++) {
    one.push_back(seconds_to_build(scene, 1));
    two.push_back(seconds_to_build(scene, 2));
    ratios.push_back(one.back() / two.back());
  }
  fmt::print("{} spheres: {:.4f} s with one thread, {:.4f} s with two, {:.2f} times as fast\n", count, median(one),
             median(two), median(ratios));
}
