// Polygons as triangles, compared with the winding number of their outline, computed by brute force.
#include "language/polygon.hpp"

#include <algorithm>
#include <numbers>
#include <random>

#include "support.hpp"

namespace penumbra {
namespace {

using Outline = std::vector<Vec3>;

struct Split {
  TriangleStore store;
  std::string problem;

  explicit Split(const Outline& outline) {
    std::vector<std::uint32_t> corners;
    for (const Vec3 p : outline) {
      corners.push_back(static_cast<std::uint32_t>(corners.size()));
      for (int axis = 0; axis < 3; axis++) store.vertices.push_back(static_cast<float>(p[axis]));
    }
    problem = append_polygon(store, corners);
  }
  Vec3 corner(std::size_t k) const {
    const float* p = &store.vertices[3 * std::size_t{store.indices[k]}];
    return {p[0], p[1], p[2]};
  }
  Outline triangle(std::size_t i) const { return {corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)}; }
};

double cross_z(Vec3 a, Vec3 b) { return a.x * b.y - a.y * b.x; }

double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); i++) sum += cross_z(outline[i], outline[(i + 1) % outline.size()]) / 2;
  return sum;
}

int winding(const Outline& outline, Vec3 point) {
  int turns = 0;
  for (std::size_t i = 0; i < outline.size(); i++) {
    const Vec3 a = outline[i], b = outline[(i + 1) % outline.size()];
    const bool left = cross_z(b - a, point - a) > 0;
    if (a.y <= point.y && b.y > point.y && left) turns++;
    if (a.y > point.y && b.y <= point.y && !left) turns--;
  }
  return turns;
}

// The triangles cover each of many points as often as the outline winds round it, or more often where `once` is false.
void expect_covers(const Outline& outline, std::mt19937& random, bool once) {
  const Split split(outline);
  ASSERT_EQ(split.problem, "");
  ASSERT_EQ(split.store.triangle_count(), outline.size() - 2);
  const int sign = area(outline) < 0 ? -1 : 1;
  double sum = 0;
  for (std::size_t i = 0; i < split.store.triangle_count(); i++) {
    const double size = area(split.triangle(i));
    sum += size;
    if (once) {
      EXPECT_GE(sign * size, -1e-5);
    }
  }
  EXPECT_NEAR(sum, area(outline), 1e-4);
  std::uniform_real_distribution<double> coordinate(-11, 11);
  for (int i = 0; i < 60; i++) {
    const Vec3 point{coordinate(random), coordinate(random), 0};
    int together = 0, covers = 0;
    for (std::size_t t = 0; t < split.store.triangle_count(); t++) {
      const int turns = winding(split.triangle(t), point);
      together += turns;
      covers += turns != 0;
    }
    const int wanted = winding(outline, point);
    ASSERT_EQ(together, wanted);
    ASSERT_GE(covers, std::abs(wanted));
    if (once) {
      ASSERT_EQ(covers, std::abs(wanted));
    }
  }
}

// From each corner as the first one.
void expect_covers_from_anywhere(Outline outline, std::mt19937& random, std::size_t steps = 1) {
  for (std::size_t i = 0; i < outline.size(); i += steps) {
    expect_covers(outline, random, true);
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(steps), outline.end());
  }
}

bool cross_each_other(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  return cross_z(b - a, c - a) * cross_z(b - a, d - a) < 0 && cross_z(d - c, a - c) * cross_z(d - c, b - c) < 0;
}

// Reverses parts of the outline until no two sides cross.
void untangle(Outline& outline) {
  const std::size_t n = outline.size();
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i + 1 < n; i++) {
      for (std::size_t k = i + 2; k < n; k++) {
        if (!cross_each_other(outline[i], outline[i + 1], outline[k], outline[(k + 1) % n])) continue;
        std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     outline.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        again = true;
      }
    }
  }
}

Outline random_outline(std::mt19937& random, std::size_t corners, bool on_grid) {
  std::uniform_real_distribution<float> anywhere(-10, 10);
  std::uniform_int_distribution<int> grid(-4, 4);
  Outline outline;
  for (std::size_t i = 0; i < corners; i++) {
    outline.push_back(on_grid ? Vec3{2.0 * grid(random), 2.0 * grid(random), 0}
                              : Vec3{anywhere(random), anywhere(random), 0});
  }
  return outline;
}

TEST(PolygonSplit, keepsFans) {
  const ZeroedVector<std::uint32_t> quad{0, 1, 2, 0, 2, 3};
  EXPECT_EQ(Split({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).store.indices, quad);
  EXPECT_EQ(Split({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}).store.indices, quad);
  EXPECT_EQ(Split({{0, 0, 0}, {0, 0, 1}, {0, 1, 1.5}, {0, 1, 0}}).store.indices, quad) << "along x";
  EXPECT_EQ(Split({{0, 0, 0}, {1, 0, .3}, {1, 1, 0}, {0, 1, .3}}).store.indices, quad) << "not planar";
  EXPECT_EQ(Split({{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}}).store.indices, quad) << "concave, but a fan";
  EXPECT_EQ(Split({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).store.indices, quad) << "no area";
  EXPECT_EQ(Split({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).store.indices, quad) << "a point";
  const double turn = 0.7;
  Outline square;
  for (const auto& [x, y] : {std::pair{0., 0.}, {.1, 0.}, {.5, 0.}, {1., 0.}, {1., .3}, {1., 1.}, {0., 1.}, {0., .4}}) {
    square.push_back({x * std::cos(turn) - y * std::sin(turn), 5, x * std::sin(turn) + y * std::cos(turn)});
  }
  const Split rotated(square);
  for (std::uint32_t i = 0; i < 6; i++) EXPECT_EQ(rotated.store.indices[3 * i], 0u) << "collinear but for rounding";
}

TEST(PolygonSplit, cutsAnArrowFromEveryCorner) {
  std::mt19937 random(1);
  expect_covers_from_anywhere({{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {0, -5, 0}, {-10, 10, 0}}, random);
  expect_covers_from_anywhere({{-10, 10, 0}, {0, -5, 0}, {10, 10, 0}, {10, -10, 0}, {-10, -10, 0}}, random);
}

TEST(PolygonSplit, coversRandomOutlines) {
  std::mt19937 random(2);
  for (int i = 0; i < 1500; i++) {
    Outline outline = random_outline(random, 4 + random() % 20, false);
    untangle(outline);
    expect_covers(outline, random, true);
    if (HasFatalFailure()) FAIL() << "outline " << i;
  }
}

// Sides touch, repeat and run back over each other.
TEST(PolygonSplit, coversWhatCrossesItselfAtLeastOnce) {
  std::mt19937 random(3);
  for (int i = 0; i < 3000; i++) {
    expect_covers(random_outline(random, 4 + random() % 16, i % 2 == 0), random, false);
    if (HasFatalFailure()) FAIL() << "outline " << i;
  }
}

// A face with a hole, as programs write it: a bridge leads to the hole and back.
TEST(PolygonSplit, cutsHolesBehindBridges) {
  std::mt19937 random(4);
  expect_covers_from_anywhere({{-9, -9, 0},
                               {9, -9, 0},
                               {9, 9, 0},
                               {-9, 9, 0},
                               {-9, -9, 0},
                               {-3, -3, 0},
                               {-3, 3, 0},
                               {3, 3, 0},
                               {3, -3, 0},
                               {-3, -3, 0}},
                              random);
  // Two holes in a row, with their bridges on one line; another touches the edge.
  expect_covers_from_anywhere({{-10, -10, 0},
                               {10, -10, 0},
                               {10, 10, 0},
                               {-10, 10, 0},
                               {-10, 0, 0},
                               {-8, 0, 0},
                               {-6, 2, 0},
                               {-4, 0, 0},
                               {0, 0, 0},
                               {2, 2, 0},
                               {4, 0, 0},
                               {2, -2, 0},
                               {0, 0, 0},
                               {-4, 0, 0},
                               {-6, -2, 0},
                               {-8, 0, 0},
                               {-10, 0, 0}},
                              random);
  expect_covers_from_anywhere(
      {{0, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}, {-9, -9, 0}, {0, -9, 0}, {-4, 0, 0}, {0, 4, 0}, {4, 0, 0}},
      random);
}

TEST(PolygonSplit, cutsSpiralsAndCombs) {
  std::mt19937 random(5);
  Outline spiral, comb;
  for (int i = 0; i < 90; i++) {
    const double angle = 0.3 * i, radius = 1 + 0.09 * i;
    spiral.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  for (int i = 89; i >= 0; i--) {
    const double angle = 0.3 * i, radius = 1.4 + 0.09 * i;
    spiral.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  expect_covers_from_anywhere(spiral, random, 7);
  for (int i = 0; i <= 40; i++) comb.push_back({-10 + 0.5 * i, i % 2 == 0 ? -10. : 9., 0});
  comb.push_back({10, 10, 0});
  comb.push_back({-10, 10, 0});
  expect_covers_from_anywhere(comb, random, 3);
}

TEST(PolygonSplit, hasALimitWhereEarsAreNeeded) {
  Outline circle;
  for (int i = 0; i < 20'000; i++) {
    const double angle = 2 * std::numbers::pi * i / 20'000;
    circle.push_back({10 * std::cos(angle), 10 * std::sin(angle), 0});
  }
  EXPECT_EQ(Split(circle).problem, "");
  for (std::size_t i = 0; i < circle.size(); i += 2) circle[i] = circle[i] * 0.5;
  EXPECT_EQ(Split(circle).problem, "this face has 20000 corners and is not convex; then at most 10000 can be split");
  circle.resize(10'000);
  EXPECT_EQ(Split(circle).store.triangle_count(), 9'998u);
}

TEST(PolygonSplit, servesEveryWayToGiveAPolygon) {
  const ZeroedVector<std::uint32_t> wanted =
      Split({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, -.5, 0}, {-1, 1, 0}}).store.indices;
  EXPECT_NE(wanted, (ZeroedVector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4}));
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertex = "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string corners = "-1 -1 0\n1 -1 0\n1 1 0\n0 -0.5 0\n-1 1 0\n";
  const Files files = {
      {"a.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv 0 -0.5 0\nv -1 1 0\nf 1 2 3 4 5\n"},
      {"b.ply", head + vertex + face + "end_header\n" + corners + "5 0 1 2 3 4\n"},
      {"c.ply", head + face + vertex + "end_header\n5 0 1 2 3 4\n" + corners},
  };
  for (const auto& [name, text] : files) {
    EXPECT_EQ(scene_of(light + "mesh " + name + "\n", {}, files).triangles->indices, wanted) << name;
  }
  EXPECT_EQ(scene_of(light + "begin\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 1 1 0\nvertex 0 -.5 0\nvertex -1 1 0\nend\n")
                .triangles->indices,
            wanted);
}

}  // namespace
}  // namespace penumbra
