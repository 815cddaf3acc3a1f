#include "support.hpp"

namespace penumbra {
namespace {

const std::string quad = "begin\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nend\n";

TEST(Shapes, areReadInEveryForm) {
  const Scene scene = scene_of(light +
                               "sphere 2 1 2 3\nmoving_sphere .5 1 2 3 4 6 8\nbox 1 5 -4 0 2 -6\n"
                               "cylinder 1 2 3 4 5\nhollow_cylinder 1 2 3 5 4\ncone 1 2 3 4 5\n" +
                               triangle);
  ASSERT_EQ(scene.root.objects.size(), 7u);
  const auto& objects = scene.root.objects;
  EXPECT_EQ(shape_of<Sphere>(objects[0]).center, (Vec3{1, 2, 3}));
  EXPECT_EQ(shape_of<Sphere>(objects[0]).radius, 2);
  EXPECT_EQ(objects[0].motion, (Vec3{}));
  EXPECT_EQ(shape_of<Sphere>(objects[1]).center, (Vec3{1, 2, 3}));
  EXPECT_EQ(objects[1].motion, (Vec3{3, 4, 5}));
  EXPECT_EQ(shape_of<Box>(objects[2]).lo, (Vec3{0, 2, -6}));
  EXPECT_EQ(shape_of<Box>(objects[2]).hi, (Vec3{1, 5, -4}));
  const auto& capped = shape_of<Cylinder>(objects[3]);
  EXPECT_TRUE(capped.capped);
  EXPECT_EQ(capped.x, 2);
  EXPECT_EQ(capped.z, 3);
  EXPECT_EQ(capped.y_min, 4);
  EXPECT_EQ(capped.y_max, 5);
  const auto& hollow = shape_of<Cylinder>(objects[4]);
  EXPECT_FALSE(hollow.capped);
  EXPECT_EQ(hollow.y_min, 4);
  EXPECT_EQ(hollow.y_max, 5);
  const auto& cone = shape_of<Cone>(objects[5]);
  EXPECT_EQ(cone.apex, (Vec3{1, 2, 3}));
  EXPECT_EQ(cone.height, 4);
  EXPECT_EQ(cone.slope, 5);
  EXPECT_EQ(shape_of<TriangleRange>(objects[6]).count, 1u);
  for (const Object& object : objects) EXPECT_EQ(object.placement, 0u);
}

TEST(Shapes, takeTheMatrixOfTheirLine) {
  const Scene scene =
      scene_of(light + "push\ntranslate 1 2 3\nscale 2 1 1\nsphere 1 0 0 0\nbox 0 0 0 1 1 1\npop\n" + ball);
  const auto& objects = scene.root.objects;
  ASSERT_EQ(scene.placements.size(), 2u) << "equal matrices in a row are kept once";
  EXPECT_EQ(objects[0].placement, 1u);
  EXPECT_EQ(objects[1].placement, 1u);
  EXPECT_EQ(objects[2].placement, 0u);
  EXPECT_EQ(transform_point(scene.placements[1], {1, 1, 1}), (Vec3{3, 3, 4})) << "the later matrix is applied first";
}

TEST(Shapes, followEveryMatrixCommand) {
  const auto placed = [](const std::string& commands, Vec3 p) {
    const Scene scene = scene_of(light + commands + "\n" + ball);
    return transform_point(scene.placements.at(scene.root.objects[0].placement), p);
  };
  expect_near(placed("translate 1 2 3", {1, 1, 1}), {2, 3, 4});
  expect_near(placed("scale 2 3 -4", {1, 1, 1}), {2, 3, -4});
  expect_near(placed("rotate 90 0 0 5", {1, 0, 0}), {0, 1, 0});
  expect_near(placed("rotate 120 1 1 1", {1, 0, 0}), {0, 1, 0});
  expect_near(placed("rotate 90 1e-30 0 0", {0, 1, 0}), {0, 0, 1});
  expect_near(placed("rotatex 90", {0, 1, 0}), {0, 0, 1});
  expect_near(placed("rotatey 90", {0, 0, 1}), {1, 0, 0});
  expect_near(placed("rotatez 90", {1, 0, 0}), {0, 1, 0});
  expect_near(placed("translate 1 0 0\npush\nrotatez 90\npop\nscale 2 2 2", {1, 0, 0}), {3, 0, 0});
}

TEST(Shapes, carryTheMotionOfAMovingSphereThroughTheMatrix) {
  const Scene scene =
      scene_of(light + "translate 5 5 5\nscale 2 1 1\nmoving_sphere 1 0 0 0 1 1 1\nmoving_object 0 0 7\n");
  EXPECT_EQ(scene.root.objects[0].motion, (Vec3{2, 1, 8}));
}

TEST(Triangles, areStoredWhereTheMatrixPutsThem) {
  const Scene scene = scene_of(light + "translate 10 0 0\nscale 2 2 2\n" + triangle);
  const std::vector<Vec3> c = corners(scene, 0);
  EXPECT_EQ(c[0], (Vec3{10, 0, 0}));
  EXPECT_EQ(c[1], (Vec3{12, 0, 0}));
  EXPECT_EQ(c[2], (Vec3{10, 2, 0}));
  EXPECT_EQ(scene.root.objects[0].placement, 0u);
}

TEST(Triangles, takeTheMatrixOfEachVertex) {
  const Scene scene =
      scene_of(light + "begin\nvertex 0 0 0\nvertex 1 0 0\npush\ntranslate 0 0 9\nvertex 0 1 0\npop\nend\n");
  EXPECT_EQ(corners(scene, 0)[2], (Vec3{0, 1, 9}));
}

TEST(Triangles, areRoundedOnceFromDoublePrecision) {
  const Scene scene = scene_of(light + "translate 0.1 0 0\nbegin\nvertex 0.2 0 0\nvertex 1 0 0\nvertex 0 1 0\nend\n");
  EXPECT_EQ(corners(scene, 0)[0].x, static_cast<double>(static_cast<float>(0.1 + 0.2)));
}

TEST(Triangles, splitPolygonsAsAFan) {
  const Scene scene = scene_of(light + quad);
  ASSERT_EQ(scene.triangles->triangle_count(), 2u);
  EXPECT_EQ(scene.triangles->indices, (ZeroedVector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  ASSERT_EQ(scene.root.objects.size(), 1u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[0]).count, 2u);
}

TEST(Triangles, inARowAreOneObject) {
  const Scene scene = scene_of(light + triangle + triangle + quad + triangle);
  ASSERT_EQ(scene.root.objects.size(), 1u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[0]).count, 5u);
}

TEST(Triangles, ofAnotherSurfaceAreAnotherObject) {
  const Scene scene = scene_of(light + triangle + "diffuse 1 0 0 0 0 0\n" + triangle + triangle + ball + triangle);
  ASSERT_EQ(scene.root.objects.size(), 4u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[1]).first, 1u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[1]).count, 2u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[3]).first, 3u);
}

TEST(Triangles, moveOneByOne) {
  const Scene scene =
      scene_of(light + triangle + triangle + quad + "moving_object 1 2 3\nmoving_object 1 0 0\n" + triangle + triangle);
  ASSERT_EQ(scene.root.objects.size(), 3u);
  const auto& objects = scene.root.objects;
  EXPECT_EQ(shape_of<TriangleRange>(objects[0]).count, 2u);
  EXPECT_EQ(objects[0].motion, (Vec3{}));
  EXPECT_EQ(shape_of<TriangleRange>(objects[1]).first, 2u);
  EXPECT_EQ(shape_of<TriangleRange>(objects[1]).count, 2u) << "all of the last polygon";
  EXPECT_EQ(objects[1].motion, (Vec3{2, 2, 3}));
  EXPECT_EQ(shape_of<TriangleRange>(objects[2]).first, 4u);
  EXPECT_EQ(shape_of<TriangleRange>(objects[2]).count, 2u);
}

TEST(Triangles, areNamedOneByOne) {
  const Scene scene = scene_of(light + triangle + triangle + "named_object t\n" + triangle + "instance t\n");
  ASSERT_EQ(scene.definitions.size(), 1u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.definitions[0]).first, 1u);
  ASSERT_EQ(scene.root.objects.size(), 3u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[0]).count, 1u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[1]).first, 2u);
}

TEST(Triangles, ignoreTextureCoordinates) {
  EXPECT_EQ(
      scene_of(light + "begin\ntexture_coord 0 0\nvertex 0 0 0\ntexture_coord 0 1\nvertex 0 1 0\nvertex 1 0 0\nend\n")
          .triangles->triangle_count(),
      1u);
}

TEST(Course, movesOnlyTheCentreOfASphere) {
  const Scene scene = scene_of(light + "translate 1 0 0\nrotatez 90\nscale 3 3 3\nsphere 2 1 0 0\n", {.course = true});
  EXPECT_EQ(shape_of<Sphere>(scene.root.objects[0]).radius, 2);
  expect_near(shape_of<Sphere>(scene.root.objects[0]).center, {1, 3, 0});
  EXPECT_EQ(scene.root.objects[0].placement, 0u);
}

TEST(Course, movesBothCentresOfAMovingSphere) {
  const Scene scene = scene_of(light + "translate 5 0 0\nscale 2 2 2\nmoving_sphere 1 1 0 0 1 3 0\n", {.course = true});
  EXPECT_EQ(shape_of<Sphere>(scene.root.objects[0]).center, (Vec3{7, 0, 0}));
  EXPECT_EQ(shape_of<Sphere>(scene.root.objects[0]).radius, 1);
  EXPECT_EQ(scene.root.objects[0].motion, (Vec3{0, 6, 0}));
}

TEST(Course, movesTheTwoCornersOfABoxAndSortsThem) {
  const Scene scene = scene_of(light + "translate 0 0 -5\nrotatez 180\nbox 1 1 0 2 3 1\n", {.course = true});
  const auto& box = shape_of<Box>(scene.root.objects[0]);
  expect_near(box.lo, {-2, -3, -5});
  expect_near(box.hi, {-1, -1, -4});
  EXPECT_EQ(scene.root.objects[0].placement, 0u);
}

TEST(Course, leavesTheRestToTheFullMatrix) {
  const Scene scene =
      scene_of(light + "scale 2 1 1\ncylinder 1 0 0 0 1\nsphere 1 0 0 0\nnamed_object s\ninstance s\ncone 0 0 0 1 1\n",
               {.course = true});
  EXPECT_EQ(scene.root.objects[0].placement, 1u);
  EXPECT_EQ(scene.definitions[0].placement, 0u);
  EXPECT_EQ(scene.root.objects[1].placement, 1u) << "an instance has its full matrix";
  EXPECT_EQ(scene.root.objects[2].placement, 1u);
}

TEST(Course, refusesPositionsThatAreTooFar) {
  const std::string expected =
      "s.cli:2:1: error: the current matrix moves the shape too far away\n  sphere 1 1e30 0 0\n  ^~~~~~\n";
  EXPECT_EQ(told("scale 1e30 1 1\nsphere 1 1e30 0 0\n", {.course = true}), expected);
}

}  // namespace
}  // namespace penumbra
