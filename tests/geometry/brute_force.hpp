// The world once more, as simple as can be: every shape is asked, one ray at a time, in double precision, with the
// chain of motions and matrices applied step by step. What the packets answer is compared with this.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "scene/scene.hpp"

namespace penumbra::test {

struct BruteRay {
  Vec3 origin, direction;  // direction of any length
  double time = 0;
};

struct BruteHit {
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t surface = 0;
  Vec3 normal;  // outward, unit; of a triangle along (B-A)x(C-A)
  Vec3 point;

  bool found() const { return distance < std::numeric_limits<double>::infinity(); }
};

class BruteForce {
 public:
  explicit BruteForce(const Scene& scene);

  // The nearest hit beyond 0; at equal distance that of the object named first.
  BruteHit intersect(const BruteRay& ray) const;

 private:
  struct Step {  // outer space = matrix * inner space + time * motion
    Vec3 motion;
    Affine inverse;
  };
  struct Item {
    Shape shape;
    std::uint32_t surface;
    std::vector<Step> steps;    // from the world inward
    std::vector<Vec3> corners;  // of triangles, three to each
    Vec3 center;                // of a ball round the triangles
    double radius_squared = 0;
  };

  void add(const Object& object, std::vector<Step> steps);
  void add_corners(Item& item, TriangleRange range) const;

  const Scene& scene_;
  std::vector<Item> items_;
};

}  // namespace penumbra::test
