#include "geometry/view_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/object_bounds.hpp"

namespace penumbra {
namespace {

// What the picture shows, a little wider: points a right + b up - c back from the eye with c > 0, |a| <= x c, |b| <= y
// c.
struct ViewPyramid {
  explicit ViewPyramid(const Scene& scene) {
    const Camera& camera = scene.camera;
    const double half = 1.02 * std::tan(camera.fov_degrees * std::numbers::pi / 360);
    const double shorter = std::min(scene.settings.width, scene.settings.height);
    x = half * scene.settings.width / shorter;
    y = half * scene.settings.height / shorter;
    from_world = inverse(Affine{{camera.right, camera.up, -camera.back}, camera.eye});
    view = -normalize(camera.back);
  }

  // For each of its sides, and for the plane of the eye: whether a point is beyond it.
  std::array<bool, 5> beyond(Vec3 world) const {
    const Vec3 p = transform_point(from_world, world);
    return {p.z <= 0, p.x > x * p.z, -p.x > x * p.z, p.y > y * p.z, -p.y > y * p.z};
  }

  double x, y;
  Affine from_world;
  Vec3 view;
};

// What an object may look like, at any time of the shutter and from any point of the lens.
Bounds blurred(const Scene& scene, const Bounds& bounds) {
  const Camera& camera = scene.camera;
  if (!(camera.lens_radius > 0)) return bounds;
  const double farthest = length(max(abs(bounds.lo - camera.eye), abs(bounds.hi - camera.eye)));
  return grow(bounds, camera.lens_radius * (1 + farthest / camera.focus_distance));
}

// The point in the space of the object, without its motion.
bool is_inside(const Sphere& sphere, Vec3 p) { return length(p - sphere.center) < sphere.radius; }
bool is_inside(const Box& box, Vec3 p) {
  return p.x > box.lo.x && p.y > box.lo.y && p.z > box.lo.z && p.x < box.hi.x && p.y < box.hi.y && p.z < box.hi.z;
}
bool is_inside(const Cylinder& c, Vec3 p) {
  return c.capped && p.y > c.y_min && p.y < c.y_max && std::hypot(p.x - c.x, p.z - c.z) < c.radius;
}
bool is_inside(const Cone& cone, Vec3 p) {
  const Vec3 d = p - cone.apex;
  return d.y > 0 && d.y < cone.height && std::hypot(d.x, d.z) < cone.slope * d.y;
}

// Looks for the opaque solid around a point, and gives up after so many objects: names can stand for any number.
class SolidSearch {
 public:
  SolidSearch(const Scene& scene, double time) : scene_(scene), time_(time) {}

  // The solid that a point of the object's group is inside of; null if there is none.
  const Object* around(const Object& object, Vec3 p) {
    if (left_ == 0) return nullptr;
    left_--;
    if (std::holds_alternative<TriangleRange>(object.shape)) return nullptr;
    const Vec3 still = p - object.motion * time_;
    if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape)) {
      for (const Object& member : (*group)->objects) {
        if (const Object* const found = around(member, still)) return found;
      }
      return nullptr;
    }
    const Vec3 own =
        object.placement == 0 ? still : transform_point(inverse(scene_.placements[object.placement]), still);
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      return around(scene_.definitions[instance->definition], own);
    }
    const bool inside = std::visit(
        [own]<class Shape>(const Shape& shape) {
          if constexpr (AnalyticShape<Shape>) return is_inside(shape, own);
          return false;
        },
        object.shape);
    return inside && scene_.surfaces[object.surface].transmission == 0 ? &object : nullptr;
  }

 private:
  const Scene& scene_;
  double time_;
  int left_ = 1 << 20;
};

bool contains(const Bounds& outer, const Bounds& inner) {
  const Bounds both = include(outer, inner);
  return !is_empty(inner) && both.lo == outer.lo && both.hi == outer.hi;
}

}  // namespace

std::string empty_view_warning(const Scene& scene, bool moves) {
  const ViewPyramid pyramid(scene);
  ObjectBounds at_open(scene, scene.camera.shutter_open), at_close(scene, scene.camera.shutter_close);
  bool any = false, all_behind = true;
  for (const Object& object : scene.root.objects) {
    Bounds bounds = at_open.of(object);
    if (moves) bounds = include(bounds, at_close.of(object));
    if (is_empty(bounds)) continue;
    any = true;
    std::array<bool, 5> all_beyond{true, true, true, true, true};
    const Bounds wide = blurred(scene, bounds);
    for (int corner = 0; corner < 8; corner++) {
      const std::array<bool, 5> beyond = pyramid.beyond(
          {corner & 1 ? wide.hi.x : wide.lo.x, corner & 2 ? wide.hi.y : wide.lo.y, corner & 4 ? wide.hi.z : wide.lo.z});
      for (std::size_t i = 0; i < beyond.size(); i++) all_beyond[i] = all_beyond[i] && beyond[i];
    }
    if (std::find(all_beyond.begin(), all_beyond.end(), true) == all_beyond.end()) return {};
    all_behind = all_behind && all_beyond[0];
  }
  if (!any) return {};
  return fmt::format(
      "nothing is in view: all objects are {}; the eye is at {:g} {:g} {:g} and looks along {:g} {:g} {:g}",
      all_behind ? "behind the eye" : "outside the picture", scene.camera.eye.x, scene.camera.eye.y, scene.camera.eye.z,
      pyramid.view.x + 0.0, pyramid.view.y + 0.0, pyramid.view.z + 0.0);
}

std::string buried_eye_warning(const Scene& scene) {
  const double time = scene.camera.shutter_open;
  ObjectBounds bounds_of(scene, time);
  SolidSearch search(scene, time);
  for (const Object& object : scene.root.objects) {
    const Object* const solid = search.around(object, scene.camera.eye);
    if (solid == nullptr) continue;
    const Bounds around = bounds_of.of(object);
    const bool holds_others =
        std::any_of(scene.root.objects.begin(), scene.root.objects.end(),
                    [&](const Object& other) { return &other != &object && contains(around, bounds_of.of(other)); });
    if (holds_others) continue;
    return fmt::format("the eye is inside an opaque {}, and sees only its inner side", name_of(solid->shape).one);
  }
  return {};
}

}  // namespace penumbra
