#include "geometry/precision.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/object_bounds.hpp"

namespace penumbra {
namespace {

// An object that is fewer steps wide is warned of: points on its surface are off by some steps, which begins to show.
constexpr double fewest_steps = 256;

// The distance of neighbouring numbers of single precision near the largest coordinate.
double step_at(const Bounds& bounds) { return std::scalbn(1.0, std::ilogb(magnitude(bounds)) - 23); }

}  // namespace

std::string precision_warning(const Scene& scene) {
  ObjectBounds bounds_of(scene, 0);
  std::string sentence;
  std::size_t count = 0;
  const auto judge = [&](const Object& object, const Bounds& bounds) {
    const double width = max_component(bounds.hi - bounds.lo);
    if (is_empty(bounds) || !(width > 0) || width >= fewest_steps * step_at(bounds) || count++ > 0) return;
    const Vec3 center = (bounds.lo + bounds.hi) / 2;
    const bool triangles = std::holds_alternative<TriangleRange>(object.shape);
    sentence = fmt::format(
        "the {} at {:g} {:g} {:g} {} {:.3g} wide, but numbers of single precision, in which pictures are computed, are "
        "{:.3g} apart there",
        triangles ? "triangles" : name_of(object.shape).one, center.x, center.y, center.z, triangles ? "are" : "is",
        width, step_at(bounds));
  };
  for_each_object(scene.root.objects, bounds_of, judge);
  for (const Object& definition : scene.definitions) for_each_object({definition}, bounds_of, judge);
  if (count > 1) sentence += fmt::format(" (and so for {} more)", count - 1);
  return count > 0 ? sentence + ": move the scene to the origin" : sentence;
}

}  // namespace penumbra
