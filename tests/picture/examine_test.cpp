// Warnings of what is allowed but probably not intended, each with its place; and options that change nothing.
#include "picture/examine.hpp"

#include <gtest/gtest.h>

#include "base/test_folder.hpp"
#include "picture/option_table.hpp"

namespace penumbra {
namespace {

const std::string lamp = "light 0 9 0 1 1 1\n";
const std::string ball = "sphere 1 0 0 -4\n";

class Examine : public testing::Test {
 protected:
  // All that is said of a scene, without the name of the file.
  std::string told(const std::string& text, const PictureOptions& options = {}) const {
    const std::filesystem::path path = folder_ / "s.cli";
    test::put_content(path, text);
    std::string said;
    for (const Diagnostic& d : read_and_examine(path, options).diagnostics) said += to_string(d);
    while (said.find(path.string()) != said.npos) said.erase(said.find(path.string()), path.string().size());
    return said;
  }
  void expect_told(const std::string& text, const std::string& start) const {
    EXPECT_TRUE(told(text).starts_with(start)) << text << told(text);
  }

  test::TestFolder folder_;
};

// 1 + 1 shadow ray at the eye's hit; below it twenty levels, of two rays each: 2 (2^20 - 1) rays with a shadow ray
// each.
TEST_F(Examine, SaysThatARayMaySendMillions) {
  const std::string glass = "shiny 0 0 0 0 0 0 0 0 0 1 .5 .5 1.5\n";
  expect_told(lamp + glass + ball + "max_depth 20\n",
              ": warning: one eye ray may send up to 4.2e+06 rays, to the depth of 20: a smaller max_depth");
  EXPECT_EQ(told(lamp + glass + ball + "max_depth 17\n"), "");  // 2 + 4 (2^17 - 1) = 524,286
  EXPECT_EQ(told(lamp + "shiny 0 0 0 0 0 0 0 0 0 1 .5 0 1\n" + ball + "max_depth 100\n"), "");
  PictureOptions deep;
  deep.max_depth = 30;
  EXPECT_NE(told(lamp + glass + ball, deep), "");
}

// Nothing that examines a scene goes through all that its names stand for: the last of these would never end.
TEST_F(Examine, SaysThatNamesStandForBillions) {
  const auto nest = [](int levels, int times) {
    std::string text = lamp + "push\ntranslate 0 0 -4\nsphere 1 0 0 0\nnamed_object o0\n";
    const auto instances = [](int level, int count) {
      std::string lines;
      for (int i = 0; i < count; i++) lines += "instance o" + std::to_string(level) + "\n";
      return lines;
    };
    for (int level = 1; level <= levels; level++) {
      text += "begin_list\n" + instances(level - 1, 10) + "end_list\nnamed_object o" + std::to_string(level) + "\n";
    }
    return text + instances(levels, times) + "pop\n";
  };
  EXPECT_EQ(told(nest(9, 1)), "");
  expect_told(nest(9, 2), ": warning: the names of the scene stand for 2e+09 objects");
  expect_told(nest(18, 1), ": warning: the names of the scene stand for 1e+18 objects");
}

TEST_F(Examine, SaysThatNothingIsInView) {
  const std::string behind = ": warning: nothing is in view: all objects are behind the eye; ";
  const std::string outside = ": warning: nothing is in view: all objects are outside the picture; ";
  expect_told(lamp + "sphere 1 0 0 4\n", behind + "the eye is at 0 0 0 and looks along 0 0 -1\n");
  expect_told(lamp + "eye 0 0 -9\n" + ball, ":2:1" + behind);
  expect_told(lamp + ball + "uvw -1 0 0 0 1 0 0 0 -1\nrender\n", ":3:1" + behind);
  expect_told(lamp + "box 3 -1 2 4 1 3\nbegin\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nend\nwrite a.png\n",
              ":8:1" + behind);
  expect_told(lamp + "sphere 1 9 0 -4\n", outside);
  expect_told(lamp + "sphere 1 0 -9 -4\nsphere 1 0 0 4\n", outside);
  expect_told(lamp + ball + "named_object b\ntranslate 0 0 99\ninstance b\n", behind);
  EXPECT_EQ(told(lamp + ball + "sphere 1 0 0 4\n"), "");
  EXPECT_EQ(told(lamp + "sphere 1 9 0 -4\nfov 150\n"), "");
  EXPECT_EQ(told(lamp + "sphere 1 4 0 -4\nimage_size 200 100\n"), "") << "a wide picture shows more";
  EXPECT_EQ(told(lamp + "box -9 -2 -9 9 -1 9\n"), "") << "all around";
  EXPECT_EQ(told(lamp + "rays_per_pixel 4\nsphere 1 9 0 -4\nmoving_object -9 0 0\n"), "") << "it moves into view";
  EXPECT_EQ(told(lamp + "rays_per_pixel 4\nlens 2 1\nsphere 1 8 0 -4\n"), "") << "the lens spreads it";
  EXPECT_EQ(told("rect 0 0 5 5\n"), "");
}

TEST_F(Examine, SaysThatTheEyeIsInsideASolid) {
  const auto inside = [](const std::string& what) {
    return ": warning: the eye is inside an opaque " + what + ", and sees only its inner side\n";
  };
  expect_told(lamp + ball + "eye 0 0 -4\n", ":3:1" + inside("sphere"));
  expect_told(lamp + "box -1 -1 -1 1 1 1\n" + ball, inside("box"));
  expect_told(lamp + "cylinder 1 0 0 -1 1\n", inside("cylinder"));
  expect_told(lamp + "cone 0 -1 0 2 1\n", inside("cone"));
  expect_told(lamp + "translate 0 0 -1\nscale 9 9 9\n" + "sphere 1 0 0 0\n", inside("sphere"));
  expect_told(lamp + "sphere 1 0 5 0\nnamed_object b\ntranslate 0 -5 0\ninstance b\n", inside("sphere"));
  expect_told(lamp + "begin_list\n" + ball + "sphere 1 0 0 0\nend_list\n", inside("sphere"));
  EXPECT_EQ(told(lamp + ball + "eye 0 0 -2.99\n"), "");
  EXPECT_EQ(told(lamp + "hollow_cylinder 1 0 0 -1 1\n"), "");
  EXPECT_EQ(told(lamp + "shiny 0 0 0 0 0 0 0 0 0 1 0 1 1.5\nsphere 1 0 0 0\n"), "") << "glass";
  EXPECT_EQ(told(lamp + ball + "diffuse 0 0 0 0 0 1\nsphere 1000 0 0 0\n"), "") << "a sky";
}

TEST_F(Examine, SaysWhatOneRayCannotShow) {
  const auto noise = [](const std::string& what) {
    return ": warning: " + what + " with one ray per pixel is noise; --rays 64, or `rays_per_pixel 64`, shows it\n";
  };
  const std::string lens = "lens 0.1 4\n", disk = "disk_light 0 9 0 1 0 -1 0 1 1 1\n";
  const std::string quad = "quad_light 0 9 0 1 0 0 0 0 1 1 1 1\n", gloss = "glossy 1 1 1 0 0 0 1 0.5 0.1\n";
  const std::string blur = "translucent 0 0 0 0 0 0 1 0 0 1 1 0.1\n";
  const std::string moving = "moving_object 1 0 0\n", moving_sphere = "moving_sphere 1 0 0 -4 0 1 -4\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {lamp + lens + ball, ":2:1" + noise("the blur of a lens")},
      {lamp + "camera_lens 1 2 4\n" + ball, ":2:1" + noise("the blur of a lens")},
      {disk + ball, ":1:1" + noise("a soft shadow")},
      {lamp + quad + ball, ":2:1" + noise("a soft shadow")},
      {lamp + gloss + ball, ":2:1" + noise("gloss or blurred transmission")},
      {lamp + blur + ball, ":2:1" + noise("gloss or blurred transmission")},
      {lamp + ball + moving, ":3:1" + noise("motion")},
      {lamp + moving_sphere, ":2:1" + noise("motion")}};
  for (const auto& [scene, warning] : cases) {
    expect_told(scene, warning);
    EXPECT_EQ(told("rays_per_pixel 4\n" + scene), "") << scene;
    PictureOptions four_rays, adaptive;
    four_rays.rays = 4;
    adaptive.noise = 0.1;
    EXPECT_EQ(told(scene, four_rays), "") << scene;
    EXPECT_EQ(told("rays_per_pixel 1\n" + scene), "") << "it is meant so";
    EXPECT_EQ(told(scene, adaptive), "") << scene;
  }
  EXPECT_EQ(told(lamp + ball + moving + "shutter 0.5 0.5\n"), "");
  EXPECT_EQ(told("shadow_rays 16\n" + disk + ball), "");
  EXPECT_EQ(told("disk_light 0 9 0 0 0 -1 0 1 1 1\n" + ball), "");
  EXPECT_EQ(told("lens 0 4\n" + lamp + ball), "");
}

TEST_F(Examine, SaysEachThingOnce) {
  EXPECT_EQ(told(lamp + "sphere 1 0 0 4\nrender\nsphere 1 0 0 5\nrender\n").find("nothing"),
            told(lamp + "sphere 1 0 0 4\nrender\nsphere 1 0 0 5\nrender\n").rfind("nothing"));
}

class IdleOption : public Examine {
 protected:
  // What is said of an option on a scene.
  std::string idle(const std::string& scene, const std::string& name, const std::string& value) const {
    PictureOptions options;
    EXPECT_EQ(parse_option(option_named(name), options, value), "");
    test::put_content(folder_ / "s.cli", scene);
    const SceneFile file = read_scene(folder_ / "s.cli", {});
    const std::vector<std::string> said = idle_options(*std::get<Picture>(file.actions.front()).scene, options);
    EXPECT_LE(said.size(), 1u);
    return said.empty() ? "" : said.front();
  }
};

TEST_F(IdleOption, IsNamedWithItsReason) {
  const std::string plain = "light 0 9 0 1 1 1\ndiffuse 1 1 1 0 0 0\nsphere 1 0 0 -4\n";
  const std::string rich =
      "rays_per_pixel 9\nlens 0.1 4\ndisk_light 0 9 0 1 0 -1 0 1 1 1\nlight 0 9 0 1 1 1\n"
      "glossy 1 1 1 0 0 0 1 0.5 0.1\nsphere 1 0 0 -4\nmoving_object 1 0 0\n"
      "translucent 0 0 0 0 0 0 1 0 0 1 1 0.1\nsphere 1 3 0 -4\n"
      "surface 1 0 0 0 0 0 1 1 1 20 0\nsphere 1 -3 0 -4\n";
  const std::vector<std::array<std::string, 3>> cases = {
      {"disk-radius", "0.5", "there is no disk light"},
      {"gloss", "0.5", "no surface reflects"},
      {"blur", "0.5", "no surface transmits light"},
      {"reflection-rays", "4", "no surface reflects"},
      {"transmission-rays", "4", "no surface transmits light"},
      {"shadow-rays", "4", "no light has an area"},
      {"sampler-light", "regular", "no light has an area"},
      {"seed", "4", "nothing is random with one ray per pixel and without soft effects"},
      {"sampler", "random", "nothing is random with one ray per pixel and without soft effects"},
      {"max-depth", "4", "no surface reflects or transmits light"},
      {"shutter", "0,0.5", "nothing moves"},
      {"time", "0.5", "nothing moves"},
      {"lens-model", "cone", "there is no lens"},
      {"highlight", "phong", "no surface leaves its highlight open"},
      {"transparent-shadows", "", "no surface that transmits light casts a shadow"},
      {"without", "antialiasing", "without antialiasing, there is one ray per pixel"},
      {"without", "lens", "without lens, there is no lens"},
      {"without", "motion", "without motion, nothing moves"},
      {"without", "disk-lights", "without disk-lights, no light has an area"},
      {"without", "gloss", "without gloss, no reflection is blurred"},
      {"without", "translucency", "without translucency, no transmission is blurred"}};
  for (const auto& [name, value, why] : cases) {
    EXPECT_EQ(idle(plain, name, value), "--" + name + " changes nothing: " + why);
    EXPECT_EQ(idle(rich, name, value), "") << name;
  }
  EXPECT_EQ(idle("sphere 1 0 0 -4\n", "no-shadows", ""), "--no-shadows changes nothing: there is no light");
  EXPECT_EQ(idle(rich, "disk-radius", "2:0.5"), "--disk-radius changes nothing: light 2 is no disk light");
  EXPECT_EQ(idle(rich, "gloss", "2:0.5"), "--gloss changes nothing: surface 2 does not reflect");
  EXPECT_EQ(idle(rich, "blur", "1:0.5"), "--blur changes nothing: surface 1 does not transmit light");
}

TEST_F(IdleOption, IsToldByRenderUnlessQuiet) {
  const std::string command = "cd '" + folder_.path().string() + "' && " PENUMBRA_PROGRAM " render s.cli --size 4x4 ";
  const std::string warning = "penumbra: warning: --gloss changes nothing: no surface reflects\n";
  test::put_content(folder_ / "s.cli", lamp + ball + "render\n");
  EXPECT_NE(test::run_program(command + "--gloss 0.5").output.find(warning), std::string::npos);
  EXPECT_EQ(test::run_program(command + "--gloss 0.5 --quiet").output, "");
  test::put_content(folder_ / "s.cli", lamp + ball + "render\nreflective 1 0 0 0 0 0 0.5\n" + ball + "render\n");
  EXPECT_EQ(test::run_program(command + "--gloss 0.5").output.find(warning), std::string::npos) << "one has it";
}

}  // namespace
}  // namespace penumbra
