#include "support.hpp"

namespace penumbra {
namespace {

Surface surface_after(const std::string& commands) {
  const Scene scene = scene_of(light + commands + "\n" + ball);
  return scene.surfaces.at(scene.root.objects.at(0).surface);
}

TEST(Surfaces, areWhiteBeforeTheFirst) {
  const Surface s = surface_after("");
  EXPECT_EQ(s.diffuse, (Vec3{1, 1, 1}));
  EXPECT_EQ(s.ambient, (Vec3{}));
  EXPECT_EQ(s.specular, (Vec3{}));
  EXPECT_EQ(s.reflection, 0);
  EXPECT_EQ(s.transmission, 0);
}

TEST(Surfaces, areReadInEveryDialect) {
  Surface expected;
  expected.diffuse = {.1, .2, .3};
  EXPECT_EQ(surface_after("surface .1 .2 .3"), expected);
  expected.ambient = {.4, .5, .6};
  EXPECT_EQ(surface_after("diffuse .1 .2 .3 .4 .5 .6"), expected);
  Surface reflective = expected;
  reflective.reflection = .7;
  EXPECT_EQ(surface_after("reflective .1 .2 .3 .4 .5 .6 .7"), reflective);
  expected.specular = {.7, .8, .9};
  expected.specular_power = 20;
  expected.reflection = .25;
  expected.open_highlight = true;
  EXPECT_EQ(surface_after("surface .1 .2 .3 .4 .5 .6 .7 .8 .9 20 .25"), expected);
  expected.transmission = .75;
  expected.refraction_index = 1.5;
  EXPECT_EQ(surface_after("shiny .1 .2 .3 .4 .5 .6 .7 .8 .9 20 .25 .75 1.5"), expected);

  Surface glossy;
  glossy.diffuse = {.1, .2, .3};
  glossy.specular = {.4, .5, .6};
  glossy.specular_power = 50;
  glossy.reflection = .25;
  glossy.gloss_radius = .15;
  EXPECT_EQ(surface_after("glossy .1 .2 .3 .4 .5 .6 50 .25 .15"), glossy);
  glossy.transmission = .5;
  glossy.refraction_index = 1.25;
  glossy.blur_radius = .05;
  EXPECT_EQ(surface_after("translucent .1 .2 .3 .4 .5 .6 50 .25 .15 .5 1.25 .05"), glossy);
}

TEST(Surfaces, takeATextureUntilTheNextSurface) {
  const Surface noisy = surface_after("diffuse .8 .8 .8 .2 .2 .2\nnoise 5");
  EXPECT_EQ(noisy.texture, Texture::noise);
  EXPECT_EQ(noisy.texture_scale, 5);
  EXPECT_EQ(noisy.diffuse, (Vec3{.8, .8, .8}));
  EXPECT_EQ(surface_after("wood").texture, Texture::wood);
  EXPECT_EQ(surface_after("marble").texture, Texture::marble);
  EXPECT_EQ(surface_after("stone").texture, Texture::stone);
  EXPECT_EQ(surface_after("noise 5\ndiffuse 1 1 1 0 0 0").texture, Texture::none);
  EXPECT_EQ(surface_after("noise 5\nsurface 1 1 1").texture, Texture::none);
  EXPECT_EQ(surface_after("noise 5\nglossy 1 1 1 1 1 1 1 1 1").texture, Texture::none);
}

TEST(Surfaces, goToTheObjectsThatFollow) {
  const Scene scene = scene_of(light + ball + "surface 1 0 0\n" + ball + ball + "surface 0 1 0\n" + ball +
                               "surface 1 0 0\n" + ball + "surface 0 0 1\n");
  ASSERT_EQ(scene.surfaces.size(), 3u) << "equal surfaces are kept once, unused ones not at all";
  const auto diffuse = [&](std::size_t i) { return scene.surfaces[scene.root.objects[i].surface].diffuse; };
  EXPECT_EQ(diffuse(0), (Vec3{1, 1, 1}));
  EXPECT_EQ(diffuse(1), (Vec3{1, 0, 0}));
  EXPECT_EQ(diffuse(2), (Vec3{1, 0, 0}));
  EXPECT_EQ(diffuse(3), (Vec3{0, 1, 0}));
  EXPECT_EQ(diffuse(4), (Vec3{1, 0, 0}));
}

TEST(Surfaces, areNotChangedByPushAndPop) {
  EXPECT_EQ(surface_after("push\nsurface 1 0 0\npop").diffuse, (Vec3{1, 0, 0}));
}

}  // namespace
}  // namespace penumbra
