// The random objects.
#include "geometry/random_scene.hpp"

#include <array>
#include <limits>
#include <numbers>

namespace penumbra::test {

TriangleRange SceneMaker::triangles(std::span<const Vec3> corners) {
  TriangleStore& store = *scene_.triangles;
  const TriangleRange range{static_cast<std::uint32_t>(store.triangle_count()),
                            static_cast<std::uint32_t>(corners.size() / 3)};
  for (const Vec3& p : corners) {
    store.indices.push_back(static_cast<std::uint32_t>(store.vertices.size() / 3));
    for (int axis = 0; axis < 3; axis++) store.vertices.push_back(static_cast<float>(p[axis]));
  }
  return range;
}

std::vector<Vec3> icosphere(int levels) {
  const double g = std::numbers::phi;
  const std::array<Vec3, 12> v{Vec3{-1, g, 0}, {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                               {0, -1, -g},    {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr std::array<int, 60> faces{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                      4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                      6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  std::vector<Vec3> corners;
  for (const int i : faces) corners.push_back(normalize(v[static_cast<std::size_t>(i)]));
  for (int level = 0; level < levels; level++) {
    std::vector<Vec3> finer;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const Vec3 a = corners[i], b = corners[i + 1], c = corners[i + 2];
      const Vec3 ab = normalize(a + b), bc = normalize(b + c), ca = normalize(c + a);
      for (const Vec3& p : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) finer.push_back(p);
    }
    corners = std::move(finer);
  }
  return corners;
}

double uniform(Random& random, double lo, double hi) {
  return lo + (hi - lo) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Vec3 random_direction(Random& random) {
  const double z = uniform(random, -1, 1), angle = uniform(random, 0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

Vec3 random_point(Random& random, double extent) {
  const double x = uniform(random, -extent, extent), y = uniform(random, -extent, extent);
  return {x, y, uniform(random, -extent, extent)};
}

Affine random_placement(Random& random, double extent) {
  Affine m = translation(random_point(random, extent));
  m = m * rotation(uniform(random, 0, 360), random_direction(random));
  m = m * scaling({uniform(random, 0.5, 1.6), uniform(random, 0.5, 1.6), uniform(random, 0.5, 1.6)});
  if (random() % 3 == 0) {
    Affine shear;
    shear.column[1] = {uniform(random, -0.6, 0.6), 1, 0};
    m = m * shear;
  }
  if (random() % 4 == 0) m = m * scaling({-1, 1, 1});
  return m;
}

namespace {

Vec3 random_motion(Random& random) { return random() % 2 == 0 ? Vec3{} : random_point(random, 1.5); }

Shape random_shape(Random& random, double extent) {
  const Vec3 p = random_point(random, extent);
  switch (random() % 5) {
    case 0:
      return Sphere{p, uniform(random, 0.3, 1.5)};
    case 1:
      return Box{p, p + Vec3{uniform(random, 0.3, 2), uniform(random, 0.3, 2), uniform(random, 0.3, 2)}};
    case 2:
      return Cone{p, uniform(random, 0.4, 2.5), std::exp(uniform(random, -2, 1))};
    default:
      return Cylinder{uniform(random, 0.3, 1.2), p.x, p.z, p.y, p.y + uniform(random, 0.4, 2.5), random() % 2 == 0};
  }
}

// Loose triangles round a centre.
std::vector<Vec3> random_triangles(Random& random, std::size_t count, double extent) {
  std::vector<Vec3> corners;
  const Vec3 center = random_point(random, extent);
  for (std::size_t i = 0; i < count; i++) {
    const Vec3 p = center + random_point(random, 1.5);
    for (int k = 0; k < 3; k++) corners.push_back(p + random_point(random, 0.6));
  }
  return corners;
}

// One matrix that keeps angles, one that keeps axes, one that keeps neither.
Affine placement_of_shape(Random& random) {
  switch (random() % 4) {
    case 0:
      return {};
    case 1:
      return translation(random_point(random, 3)) * rotation(uniform(random, 0, 360), random_direction(random));
    case 2:
      return translation(random_point(random, 3)) *
             scaling({uniform(random, 0.5, 1.6), uniform(random, 0.5, 1.6), 1.2});
    default:
      return random_placement(random, 3);
  }
}

}  // namespace

SceneMaker random_scene(std::uint64_t seed, bool with_triangle_runs) {
  Random random(seed);
  SceneMaker maker;
  maker.scene().camera.shutter_open = 0;
  maker.scene().camera.shutter_close = 1;
  const auto shape = [&](double extent) {
    return maker.object(random_shape(random, extent), placement_of_shape(random), random_motion(random));
  };
  const auto run = [&](std::size_t count, double extent, Vec3 motion) {
    const std::vector<Vec3> corners = random_triangles(random, count, extent);
    return maker.object(maker.triangles(corners), {}, motion);
  };
  const auto group = [&](double extent) {
    Objects members;
    for (int i = 0; i < 2; i++) members.push_back(shape(extent));
    members.push_back(run(1, extent, random_motion(random)));
    if (with_triangle_runs) members.push_back(run(60 + random() % 100, extent, {}));
    members.push_back({SceneMaker::group({shape(extent), run(2, extent, {})}), 0, 0, random_motion(random)});
    return SceneMaker::group(std::move(members));
  };

  for (int i = 0; i < 8; i++) maker.add(shape(6));
  for (int i = 0; i < 6; i++) maker.add(run(1, 6, random_motion(random)));
  maker.add({group(5), 0, 0, random_motion(random)});
  if (with_triangle_runs) {
    for (const std::size_t count : {std::size_t{60}, std::size_t{400}, std::size_t{50}, std::size_t{90}}) {
      maker.add(run(count, 5, {}));  // the first four follow each other and may be joined
    }
    maker.add(shape(6));
    maker.add(run(300, 5, {}));
    maker.add(run(300, 5, random_point(random, 1)));
    maker.add(run(70, 5, random_point(random, 1)));
  }
  // An instance of one shape, of a group, and of an object that holds an instance, each twice.
  const std::uint32_t single = maker.define(shape(1));
  const std::uint32_t mixed = maker.define({group(1.5), 0, 0, random_motion(random)});
  const Object inner{Instance{mixed}, 0, maker.placement(random_placement(random, 1)), random_motion(random)};
  const std::uint32_t nested = maker.define({SceneMaker::group({inner, shape(1)}), 0, 0, {}});
  for (const std::uint32_t definition : {single, mixed, nested, single, mixed, nested}) {
    maker.add({Instance{definition}, 0, maker.placement(random_placement(random, 5)), random_motion(random)});
    maker.add(shape(6));
  }
  return maker;
}

ProbeRay probe_ray(Vec3 origin, Vec3 direction, double time) {
  ProbeRay ray{};
  for (int axis = 0; axis < 3; axis++) {
    ray.origin[axis] = static_cast<float>(origin[axis]);
    ray.direction[axis] = static_cast<float>(direction[axis]);
  }
  ray.time = static_cast<float>(time);
  ray.farthest = std::numeric_limits<float>::infinity();
  return ray;
}

}  // namespace penumbra::test
