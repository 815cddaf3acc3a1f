// Textbook formulas, no care for speed.
#include "geometry/brute_force.hpp"

#include <algorithm>
#include <cmath>

namespace penumbra::test {
namespace {

struct Crossing {
  double distance;
  Vec3 normal;  // any length
};

void cross_shape(const Sphere& s, Vec3 o, Vec3 d, std::vector<Crossing>& out) {
  const Vec3 from = o - s.center;
  const double a = dot(d, d), b = dot(from, d), c = dot(from, from) - s.radius * s.radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return;
  for (const double sign : {-1.0, 1.0}) {
    const double t = (-b + sign * std::sqrt(discriminant)) / a;
    out.push_back({t, from + d * t});
  }
}

void cross_shape(const Box& box, Vec3 o, Vec3 d, std::vector<Crossing>& out) {
  for (int axis = 0; axis < 3; axis++) {
    for (const bool high : {false, true}) {
      const double t = ((high ? box.hi : box.lo)[axis] - o[axis]) / d[axis];
      if (!std::isfinite(t)) continue;
      const Vec3 p = o + d * t;
      bool inside = true;
      for (int other = 0; other < 3; other++) {
        inside &= other == axis || (p[other] >= box.lo[other] && p[other] <= box.hi[other]);
      }
      Vec3 normal;
      normal[axis] = high ? 1 : -1;
      if (inside) out.push_back({t, normal});
    }
  }
}

void cross_shape(const Cylinder& cylinder, Vec3 o, Vec3 d, std::vector<Crossing>& out) {
  const double x = o.x - cylinder.x, z = o.z - cylinder.z;
  const double a = d.x * d.x + d.z * d.z, b = x * d.x + z * d.z;
  const double c = x * x + z * z - cylinder.radius * cylinder.radius;
  const double discriminant = b * b - a * c;
  if (discriminant >= 0 && a > 0) {
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-b + sign * std::sqrt(discriminant)) / a;
      const double y = o.y + t * d.y;
      if (y >= cylinder.y_min && y <= cylinder.y_max) out.push_back({t, {x + t * d.x, 0, z + t * d.z}});
    }
  }
  if (!cylinder.capped) return;
  for (const bool top : {false, true}) {
    const double t = ((top ? cylinder.y_max : cylinder.y_min) - o.y) / d.y;
    if (!std::isfinite(t)) continue;
    const double px = x + t * d.x, pz = z + t * d.z;
    if (px * px + pz * pz <= cylinder.radius * cylinder.radius) out.push_back({t, {0, top ? 1.0 : -1.0, 0}});
  }
}

void cross_shape(const Cone& cone, Vec3 o, Vec3 d, std::vector<Crossing>& out) {
  const Vec3 from = o - cone.apex;
  const double k2 = cone.slope * cone.slope;
  const double a = d.x * d.x + d.z * d.z - k2 * d.y * d.y;
  const double b = from.x * d.x + from.z * d.z - k2 * from.y * d.y;
  const double c = from.x * from.x + from.z * from.z - k2 * from.y * from.y;
  for (const double sign : {-1.0, 1.0}) {
    const double t = a == 0 ? -c / (2 * b) : (-b + sign * std::sqrt(b * b - a * c)) / a;
    const Vec3 p = from + d * t;
    if (p.y >= 0 && p.y <= cone.height) out.push_back({t, {p.x, -k2 * p.y, p.z}});
  }
  const double t = (cone.height - from.y) / d.y;
  const Vec3 p = from + d * t;
  if (p.x * p.x + p.z * p.z <= k2 * cone.height * cone.height) out.push_back({t, {0, 1, 0}});
}

void cross_triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 o, Vec3 d, std::vector<Crossing>& out) {
  const Vec3 normal = cross(b - a, c - a);
  const double t = dot(normal, a - o) / dot(normal, d);
  if (!std::isfinite(t)) return;
  const Vec3 p = o + d * t;
  const double u = dot(cross(b - a, p - a), normal);
  const double v = dot(cross(c - b, p - b), normal);
  const double w = dot(cross(a - c, p - c), normal);
  if (u >= 0 && v >= 0 && w >= 0) out.push_back({t, normal});
}

}  // namespace

BruteForce::BruteForce(const Scene& scene) : scene_(scene) {
  for (const Object& object : scene.root.objects) add(object, {});
}

void BruteForce::add(const Object& object, std::vector<Step> steps) {
  if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape)) {
    steps.push_back({object.motion, Affine{}});
    for (const Object& member : (*group)->objects) add(member, steps);
    return;
  }
  const bool placed = !std::holds_alternative<TriangleRange>(object.shape);
  steps.push_back({object.motion, placed ? inverse(scene_.placements[object.placement]) : Affine{}});
  if (const auto* instance = std::get_if<Instance>(&object.shape)) {
    add(scene_.definitions[instance->definition], steps);
  } else {
    Item item{object.shape, object.surface, std::move(steps), {}, {}, 0};
    if (const auto* range = std::get_if<TriangleRange>(&object.shape)) add_corners(item, *range);
    items_.push_back(std::move(item));
  }
}

void BruteForce::add_corners(Item& item, TriangleRange range) const {
  const std::size_t end = std::size_t{3} * (range.first + range.count);
  for (std::size_t i = std::size_t{3} * range.first; i < end; i++) {
    const float* p = &scene_.triangles->vertices[std::size_t{3} * scene_.triangles->indices[i]];
    item.corners.push_back({p[0], p[1], p[2]});
    item.center = item.center + item.corners.back() / (3.0 * range.count);
  }
  for (const Vec3& p : item.corners) {
    item.radius_squared = std::max(item.radius_squared, dot(p - item.center, p - item.center) * (1 + 1e-9));
  }
}

BruteHit BruteForce::intersect(const BruteRay& ray) const {
  BruteHit nearest;
  std::vector<Crossing> crossings;
  for (const Item& item : items_) {
    Vec3 o = ray.origin, d = ray.direction;
    for (const Step& step : item.steps) {
      o = transform_point(step.inverse, o - step.motion * ray.time);
      d = transform_vector(step.inverse, d);
    }
    crossings.clear();
    const auto cross_analytic = [&]<typename Kind>(const Kind& shape) {
      if constexpr (AnalyticShape<Kind>) cross_shape(shape, o, d, crossings);
    };
    std::visit(cross_analytic, item.shape);
    if (!item.corners.empty()) {
      const Vec3 moment = cross(item.center - o, d);
      if (dot(moment, moment) > item.radius_squared * dot(d, d)) continue;
    }
    for (std::size_t i = 0; i < item.corners.size(); i += 3) {
      cross_triangle(item.corners[i], item.corners[i + 1], item.corners[i + 2], o, d, crossings);
    }
    for (const Crossing& crossing : crossings) {
      if (!(crossing.distance > 0) || !(crossing.distance < nearest.distance)) continue;
      Vec3 normal = crossing.normal;
      for (auto step = item.steps.rbegin(); step != item.steps.rend(); ++step) {
        const auto& column = step->inverse.column;  // the inverse transpose of the matrix
        normal = {dot(column[0], normal), dot(column[1], normal), dot(column[2], normal)};
      }
      nearest = {crossing.distance, item.surface, normalize(normal), ray.origin + ray.direction * crossing.distance};
    }
  }
  return nearest;
}

}  // namespace penumbra::test
