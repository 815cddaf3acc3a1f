#include "tracing/light_clusters.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <span>

#include "base/vec.hpp"
#include "geometry/bounds.hpp"

namespace penumbra {
namespace {

constexpr std::size_t most_in_cluster = 64;

Vec3 vec_of(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

// Directions in which lights shine.
struct Cone {
  Vec3 axis{0, 0, 1};
  double angle = std::numbers::pi;  // half of it; pi: all directions
};

// The smallest cone round both, or all directions.
Cone around(const Cone& a, const Cone& b) {
  if (a.angle < b.angle) return around(b, a);
  const double between = std::acos(std::clamp(dot(a.axis, b.axis), -1.0, 1.0));
  if (between + b.angle <= a.angle) return a;
  const double angle = (a.angle + between + b.angle) / 2;
  const Vec3 across = b.axis - a.axis * dot(a.axis, b.axis);
  if (angle >= std::numbers::pi || !(length(across) > 1e-9)) return {};
  const double turn = angle - a.angle;
  return {normalize(a.axis * std::cos(turn) + normalize(across) * std::sin(turn)), angle};
}

struct Item {
  std::uint32_t number = 0;
  Bounds bounds;
  double power = 0;
  Cone cone;
};

Item item_of(const FrameLight& light, std::uint32_t number) {
  Item item;
  item.number = number;
  item.power = std::abs(light.color[0]) + std::abs(light.color[1]) + std::abs(light.color[2]);
  const auto measure = [&](const auto& l) {
    const Vec3 center = vec_of(l.center);
    item.bounds = {center, center};
    if constexpr (requires { l.u; }) {
      const Vec3 reach = abs(vec_of(l.u)) + abs(vec_of(l.v));
      item.bounds = {center - reach, center + reach};
    }
    if constexpr (requires { l.cosine_outer; }) {
      item.cone = {vec_of(l.axis), std::acos(std::clamp<double>(l.cosine_outer, -1, 1))};
    }
  };
  with_light(light, measure);
  return item;
}

double center(const Item& item, int axis) { return item.bounds.lo[axis] + item.bounds.hi[axis]; }

// The parts that lights are divided into: powers of two of neighbours.
class Divider {
 public:
  Divider(std::span<Item> items, std::size_t size) : size_(size) { divide(items); }
  std::vector<std::span<Item>> parts;

  // Halves the brightest parts until there are `count`.
  void halve_until(std::size_t count) {
    while (parts.size() < count) {
      const auto weight = [](std::span<Item> part) {
        double power = 0;
        for (const Item& item : part) power += item.power;
        return part.size() > 1 ? power : -1;
      };
      const auto brightest = std::ranges::max_element(parts, {}, weight);
      const std::span<Item> part = *brightest;
      if (part.size() < 2) return;
      split(part, part.size() / 2);
      *brightest = part.first(part.size() / 2);
      parts.push_back(part.subspan(part.size() / 2));
    }
  }

 private:
  void divide(std::span<Item> items) {
    if (items.empty()) return;
    if (items.size() <= size_ && std::has_single_bit(items.size())) return parts.push_back(items);
    const std::size_t whole = items.size() / size_;  // parts of full size
    const std::size_t left =
        whole == 0 ? std::bit_floor(items.size()) : std::max<std::size_t>((whole + 1) / 2, 1) * size_;
    split(items, left);
    divide(items.first(left));
    divide(items.subspan(left));
  }

  // Along the longest axis; the number makes the order total, so that every machine finds the same.
  static void split(std::span<Item> items, std::size_t left) {
    if (left == items.size()) return;
    Bounds b;
    for (const Item& item : items) b = include(b, item.bounds);
    const Vec3 extent = b.hi - b.lo;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(left), items.end(),
                     [axis](const Item& x, const Item& y) {
                       const double a = center(x, axis), c = center(y, axis);
                       return a != c ? a < c : x.number < y.number;
                     });
  }

  std::size_t size_;
};

LightCluster cluster_of(std::span<const Item> items, std::size_t first) {
  LightCluster cluster{};
  cluster.first = static_cast<std::uint32_t>(first);
  cluster.count = static_cast<std::uint32_t>(items.size());
  Bounds bounds;
  Cone cone = items.front().cone;
  double power = 0;
  for (const Item& item : items) {
    bounds = include(bounds, item.bounds);
    cone = around(cone, item.cone);
    power += item.power;
  }
  const Vec3 center = (bounds.lo + bounds.hi) * 0.5;
  set3(cluster.center, center);
  // Round the centre as it is in single precision.
  const double radius = length(bounds.hi - bounds.lo) / 2 + length(center - vec_of(cluster.center));
  cluster.radius = static_cast<float>(radius * (1 + 1e-6));
  cluster.power = static_cast<float>(power);
  set3(cluster.axis, cone.axis);
  cluster.cosine = cone.angle >= std::numbers::pi ? -1.0f : static_cast<float>(std::cos(cone.angle));
  return cluster;
}

}  // namespace

LightClusters make_light_clusters(const std::vector<FrameLight>& lights, int rays) {
  std::vector<Item> items;
  for (std::size_t i = 0; i < lights.size(); i++) items.push_back(item_of(lights[i], static_cast<std::uint32_t>(i)));
  const auto wanted = static_cast<std::size_t>(rays);

  // Lights that outshine a ray's share of all are alone, if not too many do.
  double power = 0;
  for (const Item& item : items) power += item.power;
  std::ranges::sort(
      items, [](const Item& a, const Item& b) { return a.power != b.power ? a.power > b.power : a.number < b.number; });
  std::size_t bright = 0;
  while (bright < wanted / 2 && items[bright].power > power / rays) bright++;
  std::vector<std::span<Item>> parts;
  for (std::size_t i = 0; i < bright; i++) parts.emplace_back(&items[i], 1);

  const std::span<Item> rest = std::span(items).subspan(bright);
  const std::size_t left = wanted - bright;
  // As large as it takes for a cluster a ray, or for not too many of them.
  const auto count = [&](std::size_t size) {
    return rest.size() / size + static_cast<std::size_t>(std::bit_width(size));
  };
  std::size_t size = 1;
  while (count(size) > left && size < most_in_cluster) size *= 2;
  while (bright + count(size) > std::max(LightClusters::most, wanted)) size *= 2;
  Divider divider(rest, size);
  divider.halve_until(left);
  parts.insert(parts.end(), divider.parts.begin(), divider.parts.end());

  LightClusters clusters;
  for (const std::span<Item> part : parts) {
    clusters.clusters.push_back(cluster_of(part, clusters.lights.size()));
    for (const Item& item : part) clusters.lights.push_back(item.number);
  }
  return clusters;
}

}  // namespace penumbra
