// Scenes of every kind of object, at random from a seed, and a builder that puts scenes together by hand.
#pragma once

#include <cstdint>
#include <random>
#include <span>

#include "scene/scene.hpp"
#include "tracing/probe.hpp"

namespace penumbra::test {

// Adds to a scene; every shape gets a surface of its own, so that the surface of a hit tells which shape it was.
class SceneMaker {
 public:
  SceneMaker() { scene_.triangles = std::make_shared<TriangleStore>(); }

  std::uint32_t new_surface() {
    scene_.surfaces.emplace_back();
    return static_cast<std::uint32_t>(scene_.surfaces.size() - 1);
  }
  std::uint32_t placement(const Affine& m) {
    scene_.placements.push_back(m);
    return static_cast<std::uint32_t>(scene_.placements.size() - 1);
  }
  Object object(Shape shape, const Affine& m = {}, Vec3 motion = {}) {
    return {std::move(shape), new_surface(), placement(m), motion};
  }
  // Triangles with these corners, three to each.
  TriangleRange triangles(std::span<const Vec3> corners);
  std::uint32_t define(Object object) {
    scene_.definitions.push_back(std::move(object));
    return static_cast<std::uint32_t>(scene_.definitions.size() - 1);
  }
  void add(Object object) { scene_.root.objects.push_back(std::move(object)); }
  static Shape group(Objects objects) { return std::make_shared<const Group>(Group{std::move(objects)}); }

  const Scene& scene() const { return scene_; }
  Scene& scene() { return scene_; }

 private:
  Scene scene_;
};

// A closed convex mesh whose triangles face outward: an icosahedron, split `levels` times, on the unit sphere.
std::vector<Vec3> icosphere(int levels);

using Random = std::mt19937_64;
double uniform(Random& random, double lo, double hi);
Vec3 random_direction(Random& random);
Vec3 random_point(Random& random, double extent);
// Turned, scaled by 0.5 to 1.6 along each axis, sometimes sheared or mirrored, shifted by up to `extent`.
Affine random_placement(Random& random, double extent);

// About 40 objects with coordinates up to about 10. Runs of 60 to 400 triangles are among them, for an Embree threshold
// between; `with_triangle_runs` false leaves out all but single triangles.
SceneMaker random_scene(std::uint64_t seed, bool with_triangle_runs);

ProbeRay probe_ray(Vec3 origin, Vec3 direction, double time);

}  // namespace penumbra::test
