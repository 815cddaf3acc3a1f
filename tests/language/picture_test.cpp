// What a picture holds: the scene as it stands at its line, shared between pictures if nothing has changed.
#include "support.hpp"

namespace penumbra {
namespace {

TEST(Pictures, areTakenAtTheirLine) {
  const SceneFile file =
      read(light + "fov 30\n" + ball + "write a.png\nfov 40\n" + ball + "moving_object 1 0 0\nrender\n");
  const std::vector<Picture> list = pictures(file);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].file, "a.png");
  EXPECT_EQ(list[0].scene->camera.fov_degrees, 30);
  EXPECT_EQ(list[0].scene->root.objects.size(), 1u);
  EXPECT_EQ(list[1].file, "");
  EXPECT_EQ(list[1].scene->camera.fov_degrees, 40);
  EXPECT_EQ(list[1].scene->root.objects.size(), 2u);
}

// Each of these changes the scene between two pictures; the first picture must not see it.
TEST(Pictures, keepWhatTheySaw) {
  const std::string start = light + ball + "named_object n\n" + triangle + triangle + ball;
  for (const char* change :
       {"moving_object 1 0 0", "named_object m", "instance n", "light 0 0 0 1 1 1", "eye 1 1 1", "background 1 1 1",
        "sphere 1 0 0 0", "image_size 10 10", "seed 4", "begin\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nend",
        "begin_list\nsphere 1 0 0 0\nend_list", "rays_per_pixel 4", "max_depth 2", "sampler random", "shutter 0 0",
        "lens 1 1", "uvw 1 0 0 0 1 0 0 0 2", "disk_light 0 0 0 1 0 1 0 1 1 1", "spotlight 0 0 0 0 1 0 1 2 1 1 1"}) {
    const std::vector<Picture> alone = pictures(read(start + "render\n"));
    const std::vector<Picture> list = pictures(read(start + "render\n" + change + "\nrender\n"));
    ASSERT_EQ(list.size(), 2u) << change;
    EXPECT_NE(list[0].scene, list[1].scene) << change;
    const Scene &a = *alone[0].scene, &b = *list[0].scene;
    ASSERT_EQ(a.root.objects.size(), b.root.objects.size()) << change;
    for (std::size_t i = 0; i < a.root.objects.size(); i++) {
      EXPECT_EQ(a.root.objects[i].motion, b.root.objects[i].motion) << change;
    }
    EXPECT_EQ(a.lights.size(), b.lights.size()) << change;
    EXPECT_EQ(a.definitions.size(), b.definitions.size()) << change;
    EXPECT_EQ(a.camera.eye, b.camera.eye) << change;
    EXPECT_EQ(a.camera.lens_radius, b.camera.lens_radius) << change;
    EXPECT_EQ(a.camera.back, b.camera.back) << change;
    EXPECT_EQ(a.camera.shutter_close, b.camera.shutter_close) << change;
    EXPECT_EQ(a.background, b.background) << change;
    EXPECT_TRUE(a.settings == b.settings) << change;
    EXPECT_EQ(a.surfaces, b.surfaces) << change;
    EXPECT_EQ(shape_of<TriangleRange>(b.root.objects[0]).count, 2u) << change;
  }
}

TEST(Pictures, shareTheSceneWhereNothingChanged) {
  const SceneFile file = read(light + ball +
                              "write a.png\nreset_timer\npush\ntranslate 1 0 0\nsurface 1 0 0\npop\n"
                              "rect 0 0 5 5\nwrite b.png\n" +
                              triangle + "write c.png\n");
  const std::vector<Picture> list = pictures(file);
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].scene, list[1].scene);
  EXPECT_NE(list[1].scene, list[2].scene);
  EXPECT_EQ(list[1].scene->triangles, list[2].scene->triangles) << "triangles are never copied";
}

TEST(Pictures, seeOpenGroups) {
  const SceneFile file = read(light + ball + "begin_list\n" + ball + "begin_list\n" + ball + ball + "render\n" + ball +
                              "end_list\nend_list\nrender\n");
  const std::vector<Picture> list = pictures(file);
  ASSERT_EQ(list.size(), 2u);
  ASSERT_EQ(list[0].scene->root.objects.size(), 2u);
  const auto& outer = *shape_of<std::shared_ptr<const Group>>(list[0].scene->root.objects[1]);
  ASSERT_EQ(outer.objects.size(), 2u);
  EXPECT_EQ(shape_of<std::shared_ptr<const Group>>(outer.objects[1])->objects.size(), 2u);
}

TEST(Pictures, areOneAtTheEndIfTheFileNamesNone) {
  const std::vector<Picture> list = pictures(read(light + ball));
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].file, "");
}

TEST(Pictures, standAmongTimersInTheOrderOfTheFile) {
  const SceneFile file = read(light + ball + "reset_timer\nwrite a.png\nprint_timer\nwrite b.png\n");
  ASSERT_EQ(file.actions.size(), 4u);
  EXPECT_TRUE(std::holds_alternative<ResetTimer>(file.actions[0]));
  EXPECT_TRUE(std::holds_alternative<Picture>(file.actions[1]));
  EXPECT_TRUE(std::holds_alternative<PrintTimer>(file.actions[2]));
  EXPECT_EQ(std::get<Picture>(file.actions[3]).file, "b.png");
}

TEST(Pictures, getTheRectanglesBeforeThem) {
  const SceneFile file = read("rect 1 2 3 4\ncolor .1 .2 .3\nrect -5 6 7 8\nwrite a.png\nrect 0 0 1 1\nwrite b.png\n");
  const std::vector<Picture> list = pictures(file);
  ASSERT_EQ(list.size(), 2u);
  ASSERT_EQ(list[0].rects.size(), 2u);
  EXPECT_EQ(list[0].rects[0].color, (Vec3{1, 1, 1}));
  EXPECT_EQ(list[0].rects[0].x0, 1);
  EXPECT_EQ(list[0].rects[0].y0, 2);
  EXPECT_EQ(list[0].rects[0].x1, 3);
  EXPECT_EQ(list[0].rects[0].y1, 4);
  EXPECT_EQ(list[0].rects[1].x0, -5);
  EXPECT_EQ(list[0].rects[1].color, (Vec3{.1, .2, .3}));
  ASSERT_EQ(list[1].rects.size(), 1u);
  EXPECT_EQ(list[1].rects[0].color, (Vec3{.1, .2, .3}));
}

TEST(Pictures, ofAWrongSceneAreNone) {
  EXPECT_TRUE(read(light + ball + "write a.png\nfoo\nwrite b.png\n").actions.empty());
}

}  // namespace
}  // namespace penumbra
