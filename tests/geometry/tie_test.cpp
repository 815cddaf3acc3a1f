// At equal distance the object that is named first wins, whatever structure holds it: our own tree, Embree, a group, an
// instance before or after.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>

#include "base/test_scale.hpp"
#include "geometry/probing.hpp"
#include "geometry/random_scene.hpp"

namespace penumbra::test {
namespace {

// The same few triangles whenever it is asked: a closed mesh of 80.
const std::vector<Vec3> mesh_corners = [] {
  std::vector<Vec3> corners = icosphere(1);
  for (Vec3& p : corners) p = p * 1.5 + Vec3{0.3, 0.1, -0.2};
  return corners;
}();

// Ways to hold a shape that change nothing about where it is.
enum class Held { plain, group, named, nested };
constexpr std::array all_held{Held::plain, Held::group, Held::named, Held::nested};

Object held(SceneMaker& maker, const Object& object, Held way) {
  if (way == Held::plain) return object;
  if (way == Held::group) return {SceneMaker::group({object}), 0, 0, {}};
  const std::uint32_t name = maker.define({SceneMaker::group({object}), 0, 0, {}});
  if (way == Held::named) return {Instance{name}, 0, 0, {}};
  const std::uint32_t outer = maker.define({SceneMaker::group({{Instance{name}, 0, 0, {}}}), 0, 0, {}});
  return {Instance{outer}, 0, 0, {}};
}

Object make_sphere(SceneMaker& maker) { return maker.object(Sphere{{0.3, 0.1, -0.2}, 1.5}); }
Object make_box(SceneMaker& maker) { return maker.object(Box{{-1.3, -1, -1.1}, {1.2, 1.4, 1}}); }
Object make_cylinder(SceneMaker& maker) { return maker.object(Cylinder{1.2, 0.1, 0.2, -1.3, 1.1, true}); }
Object make_hollow(SceneMaker& maker) { return maker.object(Cylinder{1.2, 0.1, 0.2, -1.3, 1.1, false}); }
Object make_cone(SceneMaker& maker) { return maker.object(Cone{{0.1, -1.3, 0.2}, 2.4, 0.6}); }
Object make_ellipsoid(SceneMaker& maker) {
  return maker.object(Sphere{{0, 0, 0}, 1}, rotation(30, {1, 2, 3}) * scaling({1, 1.5, 2}));
}
Object make_moving(SceneMaker& maker) { return maker.object(Sphere{{0.3, 0.1, -0.2}, 1.5}, {}, {0.5, 0.2, 0}); }
Object make_mesh(SceneMaker& maker) { return maker.object(maker.triangles(mesh_corners)); }
Object make_moving_mesh(SceneMaker& maker) { return maker.object(maker.triangles(mesh_corners), {}, {0.25, 0.5, 0}); }

struct Kind {
  const char* name;
  Object (*make)(SceneMaker&);

  friend void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }
};
constexpr std::array kinds{Kind{"sphere", make_sphere}, Kind{"box", make_box},   Kind{"cylinder", make_cylinder},
                           Kind{"hollow", make_hollow}, Kind{"cone", make_cone}, Kind{"ellipsoid", make_ellipsoid},
                           Kind{"moving", make_moving}, Kind{"mesh", make_mesh}, Kind{"moving_mesh", make_moving_mesh}};

// Of the rays that hit anything: how many do not have `wanted`.
int hits_of_others(const Scene& scene, std::uint32_t wanted, std::uint32_t embree_threshold) {
  WorldOptions options;
  options.embree_threshold = embree_threshold;
  const World world = build_world(scene, options);
  Random random(3);
  std::vector<ProbeRay> rays;
  const int count = scaled(2000, 200);
  for (int i = 0; i < count; i++) {
    const Vec3 origin = random_direction(random) * 6;
    rays.push_back(probe_ray(origin, normalize(random_point(random, 1) - origin), i % 5 * 0.25));
  }
  int others = 0, found = 0;
  for (const Kernel* kernel : usable_kernels()) {
    for (const ProbeHit& hit : hits_of(*kernel, world, rays)) {
      if (!std::isfinite(hit.distance)) continue;
      found++;
      others += hit.surface != wanted;
    }
  }
  EXPECT_GT(found, count / 2);
  return others;
}

class Tie : public testing::TestWithParam<Kind> {};

TEST_P(Tie, FirstNamedWins) {
  for (const std::uint32_t threshold : {40u, 0xffffffffu}) {
    for (const Held first_way : all_held) {
      for (const Held second_way : all_held) {
        SceneMaker maker;
        maker.add(maker.object(Sphere{{9, 9, 9}, 0.1}));
        const Object first = GetParam().make(maker);
        maker.add(held(maker, first, first_way));
        maker.add(maker.object(Sphere{{-9, 9, 9}, 0.1}));
        maker.add(held(maker, GetParam().make(maker), second_way));
        maker.add(GetParam().make(maker));
        EXPECT_EQ(hits_of_others(maker.scene(), first.surface, threshold), 0)
            << GetParam().name << " first held in way " << static_cast<int>(first_way) << ", second in way "
            << static_cast<int>(second_way) << ", Embree from " << threshold << " triangles";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Tie, testing::ValuesIn(kinds),
                         [](const testing::TestParamInfo<Kind>& kind) { return std::string(kind.param.name); });

// The same mesh in both rooms: as one long run, which goes to Embree, and as single triangles that do not.
TEST(TieBetweenRooms, FirstNamedWins) {
  for (const bool embree_first : {true, false}) {
    SceneMaker maker;
    const std::uint32_t first = maker.new_surface(), second = maker.new_surface();
    const TriangleRange whole = maker.triangles(mesh_corners);
    const auto add_whole = [&](std::uint32_t surface) { maker.add({whole, surface, 0, {}}); };
    const auto add_pieces = [&](std::uint32_t surface) {
      for (std::uint32_t i = 0; i < whole.count; i++) {
        // A sphere between, so that the pieces are no run of triangles.
        maker.add({TriangleRange{whole.first + i, 1}, surface, 0, {}});
        maker.add({Sphere{{9, 9, 9}, 0.1}, surface, 0, {}});
      }
    };
    embree_first ? add_whole(first) : add_pieces(first);
    embree_first ? add_pieces(second) : add_whole(second);
    EXPECT_EQ(hits_of_others(maker.scene(), first, 40), 0) << (embree_first ? "Embree first" : "Embree second");
  }
}

TEST(TieBetweenRooms, FirstNamedWinsInsideOneEmbreeScene) {
  SceneMaker maker;
  const Object first = make_mesh(maker);
  maker.add(first);
  maker.add(make_mesh(maker));
  EXPECT_EQ(hits_of_others(maker.scene(), first.surface, 40), 0);
}

// A face of a box and triangles in its plane, at distances that are equal in exact arithmetic.
TEST(TieBetweenShapes, BoxAndTriangles) {
  const Vec3 a{-1, -1, 1}, b{1, -1, 1}, c{1, 1, 1}, d{-1, 1, 1};
  for (const bool box_first : {true, false}) {
    SceneMaker maker;
    const std::uint32_t first = maker.new_surface(), second = maker.new_surface();
    const auto add_box = [&](std::uint32_t surface) { maker.add({Box{{-1, -1, -1}, {1, 1, 1}}, surface, 0, {}}); };
    const auto add_face = [&](std::uint32_t surface) {
      maker.add({maker.triangles(std::array{a, b, c, c, d, a}), surface, 0, {}});
    };
    box_first ? add_box(first) : add_face(first);
    box_first ? add_face(second) : add_box(second);
    const World world = build_world(maker.scene(), {});
    Random random(3);
    std::vector<ProbeRay> rays;
    for (int i = 0; i < 2000; i++) {
      const Vec3 target{uniform(random, -0.99, 0.99), uniform(random, -0.99, 0.99), 1};
      const Vec3 origin{uniform(random, -3, 3), uniform(random, -3, 3), 4};
      rays.push_back(probe_ray(origin, normalize(target - origin), 0));
    }
    int others = 0;
    for (const ProbeHit& hit : hits_of(*usable_kernels().back(), world, rays)) others += hit.surface != first;
    EXPECT_EQ(others, 0) << (box_first ? "box first" : "triangles first");
  }
}

// Triangles of different size and place in one axis-aligned plane, a run of two and one alone, in all choices of rooms.
// The one has twice the area 41 * 12, which times its single-precision inverse is not 1.
TEST(TieBetweenTriangles, OfOneAxisAlignedPlane) {
  for (int choice = 0; choice < 18; choice++) {
    const int axis = choice % 3;
    const bool run_first = choice / 3 % 2 == 0;
    const std::uint32_t threshold = choice < 6 ? 4096 : choice < 12 ? 2 : 1;
    SceneMaker maker;
    const auto in_plane = [&](double u, double v) {
      Vec3 p;
      p[axis] = -0.7;
      p[(axis + 1) % 3] = u;
      p[(axis + 2) % 3] = v;
      return p;
    };
    const std::uint32_t first = maker.new_surface(), second = maker.new_surface();
    const auto add_run = [&](std::uint32_t surface) {
      const std::array corners{in_plane(-2.3, -1.1), in_plane(1.9, -1.7), in_plane(0.1, 2.9),
                               in_plane(5.1, 5.3),   in_plane(6.1, 5.2),  in_plane(5.7, 6.1)};
      maker.add({maker.triangles(corners), surface, 0, {}});
    };
    const auto add_single = [&](std::uint32_t surface) {
      maker.add({maker.triangles(std::array{in_plane(-20, -2), in_plane(21, -2), in_plane(0, 10)}), surface, 0, {}});
    };
    run_first ? add_run(first) : add_single(first);
    maker.add({Sphere{{9, 9, 9}, 0.1}, first, 0, {}});  // between, so that the two do not become one run
    run_first ? add_single(second) : add_run(second);
    WorldOptions options;
    options.embree_threshold = threshold;
    const World world = build_world(maker.scene(), options);
    Random random(5);
    std::vector<ProbeRay> rays;
    for (int i = 0; i < 3000; i++) {
      const Vec3 target = in_plane(uniform(random, -0.4, 0.4), uniform(random, -0.9, 0.4));
      Vec3 origin{uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3)};
      origin[axis] = 4;
      rays.push_back(probe_ray(origin, normalize(target - origin), 0));
    }
    int others = 0;
    for (const ProbeHit& hit : hits_of(*usable_kernels().back(), world, rays)) others += hit.surface != first;
    EXPECT_EQ(others, 0) << "axis " << axis << ", run first " << run_first << ", threshold " << threshold;
  }
}

}  // namespace
}  // namespace penumbra::test
