// Groups, named objects, instances, and which object `moving_object` moves.
#include "support.hpp"

namespace penumbra {
namespace {

const Group& group_of(const Object& object) { return *shape_of<std::shared_ptr<const Group>>(object); }

TEST(Groups, holdWhatStandsBetween) {
  const Scene scene = scene_of(light + ball + "begin_list\n" + ball + "begin_accel\n" + ball + triangle +
                               "end_accel\n" + ball + "end_list\n" + ball);
  ASSERT_EQ(scene.root.objects.size(), 3u);
  const Group& outer = group_of(scene.root.objects[1]);
  ASSERT_EQ(outer.objects.size(), 3u);
  EXPECT_EQ(group_of(outer.objects[1]).objects.size(), 2u);
  EXPECT_EQ(scene.root.objects[1].placement, 0u);
}

TEST(Groups, doNotSharePolygonsWithTheirSurroundings) {
  const Scene scene = scene_of(light + triangle + "begin_list\n" + triangle + triangle + "end_list\n" + triangle);
  ASSERT_EQ(scene.root.objects.size(), 3u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[0]).count, 1u);
  EXPECT_EQ(shape_of<TriangleRange>(group_of(scene.root.objects[1]).objects[0]).count, 2u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[2]).first, 3u);
}

TEST(Groups, haveTheirObjectsInWorldSpace) {
  const Scene scene = scene_of(light + "translate 1 2 3\nbegin_list\nsphere 1 0 0 0\nend_list\n");
  EXPECT_EQ(scene.root.objects[0].placement, 0u);
  EXPECT_EQ(scene.placements[group_of(scene.root.objects[0]).objects[0].placement].translation, (Vec3{1, 2, 3}));
}

TEST(MovingObject, movesTheLastShapeInWorldUnits) {
  const Scene scene = scene_of(light + ball + "scale 5 5 5\nsphere 1 0 0 0\nmoving_object 1 2 3\n" + ball);
  EXPECT_EQ(scene.root.objects[0].motion, (Vec3{}));
  EXPECT_EQ(scene.root.objects[1].motion, (Vec3{1, 2, 3})) << "not scaled";
  EXPECT_EQ(scene.root.objects[2].motion, (Vec3{}));
}

TEST(MovingObject, addsUp) {
  const Scene scene = scene_of(light + ball + "moving_object 1 2 3\nmoving_object 1 0 0\n");
  EXPECT_EQ(scene.root.objects[0].motion, (Vec3{2, 2, 3}));
}

TEST(MovingObject, movesAGroupAfterItsEnd) {
  for (const char* end : {"end_list", "end_accel"}) {
    const Scene scene =
        scene_of(light + "begin_list\n" + ball + "moving_object 0 0 1\n" + end + "\nmoving_object 1 0 0\n");
    EXPECT_EQ(scene.root.objects[0].motion, (Vec3{1, 0, 0}));
    EXPECT_EQ(group_of(scene.root.objects[0]).objects[0].motion, (Vec3{0, 0, 1}));
  }
}

TEST(MovingObject, movesAnInstanceAndNotItsDefinition) {
  const Scene scene =
      scene_of(light + ball + "moving_object 0 0 1\nnamed_object a\ninstance a\nmoving_object 1 0 0\ninstance a\n");
  EXPECT_EQ(scene.definitions[0].motion, (Vec3{0, 0, 1})) << "in the space of the definition";
  EXPECT_EQ(scene.root.objects[0].motion, (Vec3{1, 0, 0}));
  EXPECT_EQ(scene.root.objects[1].motion, (Vec3{}));
}

TEST(MovingObject, movesAMesh) {
  const Scene scene = scene_of(light + triangle + "mesh t.obj\nmoving_object 1 0 0\n" + triangle, {},
                               {{"t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n"}});
  ASSERT_EQ(scene.root.objects.size(), 3u);
  EXPECT_EQ(scene.root.objects[0].motion, (Vec3{}));
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[1]).count, 2u);
  EXPECT_EQ(scene.root.objects[1].motion, (Vec3{1, 0, 0}));
}

TEST(MovingObject, findsTheLastObjectAcrossFiles) {
  EXPECT_EQ(scene_of(light + "read b.cli\nmoving_object 1 0 0\n", {}, {{"b.cli", ball}}).root.objects[0].motion,
            (Vec3{1, 0, 0}));
}

TEST(Named, takeTheObjectOutOfTheScene) {
  const Scene scene = scene_of(light +
                               "surface 1 0 0\ntranslate 1 0 0\nsphere 2 0 0 0\nnamed_object a\nsurface 0 1 0\n"
                               "translate 0 1 0\ninstance a\nscale 2 2 2\ninstance a\n");
  ASSERT_EQ(scene.definitions.size(), 1u);
  EXPECT_EQ(shape_of<Sphere>(scene.definitions[0]).radius, 2);
  EXPECT_EQ(scene.surfaces[scene.definitions[0].surface].diffuse, (Vec3{1, 0, 0})) << "the surface of its definition";
  EXPECT_EQ(scene.placements[scene.definitions[0].placement].translation, (Vec3{1, 0, 0}));
  ASSERT_EQ(scene.root.objects.size(), 2u);
  EXPECT_EQ(shape_of<Instance>(scene.root.objects[0]).definition, 0u);
  EXPECT_EQ(scene.placements[scene.root.objects[0].placement].translation, (Vec3{1, 1, 0}));
  EXPECT_EQ(scene.placements[scene.root.objects[1].placement].column[0], (Vec3{2, 0, 0}));
}

TEST(Named, takeAGroupWithItsSurfaces) {
  const Scene scene = scene_of(light + ball + "begin_list\nsurface 1 0 0\n" + ball + "surface 0 1 0\n" + ball +
                               "end_list\nnamed_object pair\ninstance pair\n");
  ASSERT_EQ(scene.root.objects.size(), 2u);
  EXPECT_EQ(group_of(scene.definitions[0]).objects.size(), 2u);
}

TEST(Named, mayBeMadeOfInstances) {
  const Scene scene = scene_of(light + ball +
                               "named_object a\nbegin_list\ninstance a\ntranslate 1 0 0\ninstance a\nend_list\n"
                               "named_object b\ninstance b\n");
  ASSERT_EQ(scene.definitions.size(), 2u);
  EXPECT_EQ(shape_of<Instance>(group_of(scene.definitions[1]).objects[1]).definition, 0u);
  EXPECT_EQ(shape_of<Instance>(scene.root.objects[0]).definition, 1u);
}

TEST(Named, maybeMadeInsideAGroup) {
  const Scene scene = scene_of(light + "begin_list\n" + ball + ball + "named_object a\nend_list\ninstance a\n");
  EXPECT_EQ(group_of(scene.root.objects[0]).objects.size(), 1u);
  EXPECT_EQ(scene.definitions.size(), 1u);
}

}  // namespace
}  // namespace penumbra
