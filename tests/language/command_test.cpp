// The command table, and every command in every form.
#include "language/command.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <sstream>

#include "picture/reference_pages.hpp"
#include "support.hpp"

namespace penumbra {
namespace {

TEST(CommandTable, findsEveryCommandAndNothingElse) {
  std::set<std::string_view> names;
  for (const Command& command : all_commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_EQ(find_command(command.name), &command);
    EXPECT_FALSE(is_command_of_other_programs(command.name)) << command.name;
    EXPECT_FALSE(command.help.empty());
    EXPECT_NE(command.help.back(), '.') << command.name;
    EXPECT_NE(command.action, nullptr);
  }
  for (const char* name : {"", "s", "Sphere", "sphere ", "spheres", "spher", "endlist"}) {
    EXPECT_EQ(find_command(name), nullptr) << name;
  }
}

TEST(CommandTable, holdsTheWholeLanguage) {
  for (const char* name : {"background",
                           "fov",
                           "eye",
                           "uvw",
                           "lens",
                           "rays_per_pixel",
                           "render",
                           "write",
                           "read",
                           "reset_timer",
                           "print_timer",
                           "color",
                           "rect",
                           "light",
                           "point_light",
                           "disk_light",
                           "quad_light",
                           "spotlight",
                           "surface",
                           "diffuse",
                           "reflective",
                           "shiny",
                           "glossy",
                           "translucent",
                           "noise",
                           "wood",
                           "marble",
                           "stone",
                           "begin",
                           "vertex",
                           "texture_coord",
                           "end",
                           "sphere",
                           "moving_sphere",
                           "box",
                           "cylinder",
                           "hollow_cylinder",
                           "cone",
                           "mesh",
                           "moving_object",
                           "begin_list",
                           "end_list",
                           "begin_accel",
                           "end_accel",
                           "named_object",
                           "instance",
                           "push",
                           "pop",
                           "translate",
                           "scale",
                           "rotate",
                           "rotatex",
                           "rotatey",
                           "rotatez",
                           "camera_lens",
                           "image_size",
                           "sampler",
                           "seed",
                           "max_depth",
                           "shutter",
                           "reflection_rays",
                           "transmission_rays",
                           "shadow_rays",
                           "branching",
                           "light_rays",
                           "filter"}) {
    EXPECT_NE(find_command(name), nullptr) << name;
  }
  EXPECT_EQ(all_commands().size(), 68u);
}

// Every command has an error for one argument too many and, if it takes any, for one too few.
TEST(CommandTable, checksTheNumberOfArgumentsOfEveryCommand) {
  for (const Command& command : all_commands()) {
    for (const int change : {-1, 1}) {
      const Form& form = command.forms.back();
      const int count = form.count() + change;
      const bool is_optional = command.forms.size() > 1 && command.forms.front().count() == count;
      if (count < 0 || is_optional) continue;
      std::string text(command.name);
      for (int i = 0; i < count; i++) text += " 1";
      const SceneFile file = read(text);
      ASSERT_FALSE(file.diagnostics.empty()) << text;
      EXPECT_EQ(file.diagnostics[0].message, "`" + std::string(command.name) + "` takes " + what_it_takes(command) +
                                                 "; found " + std::to_string(count));
      EXPECT_EQ(file.diagnostics[0].column, change < 0 ? 1 : static_cast<int>(text.size())) << text;
    }
  }
}

// Every numeric argument of every command in every form must be a number.
TEST(CommandTable, checksTheKindOfEveryArgument) {
  for (const Command& command : all_commands()) {
    for (const Form& form : command.forms) {
      for (int bad = 0; bad < form.count(); bad++) {
        const Argument& argument = form.argument[static_cast<std::size_t>(bad)];
        if (!argument.is_number()) continue;
        std::string text(command.name);
        for (int i = 0; i < form.count(); i++) text += i == bad ? " one" : " 1";
        const SceneFile file = read(text);
        ASSERT_FALSE(file.diagnostics.empty()) << text;
        EXPECT_EQ(file.diagnostics[0].message,
                  fmt::format("`{}` of `{}` has to be a number; found `one`", argument.name, command.name));
        EXPECT_EQ(file.diagnostics[0].column, static_cast<int>(command.name.size()) + 2 + 2 * bad);
        EXPECT_EQ(file.diagnostics[0].width, 3);
      }
    }
  }
}

TEST(CommandTable, sharesItsTextWithTheReferencePage) {
  const std::string page = language_markdown(PENUMBRA_ROOT "/docs/templates/language.md");
  for (const Command& command : all_commands()) {
    EXPECT_NE(page.find(fmt::format("`{}`", command.name)), std::string::npos) << command.name;
    EXPECT_NE(page.find(command.help), std::string::npos) << command.name;
  }
  EXPECT_NE(page.find("| `sphere` radius x y z | a sphere round the point x y z | radius: greater than 0 |"),
            std::string::npos);
}

TEST(CommandTable, isWhatTheReferencePageWasMadeFrom) {
  std::ifstream file(PENUMBRA_ROOT "/docs/language.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_EQ(page.str(), language_markdown(PENUMBRA_ROOT "/docs/templates/language.md"))
      << "build the target language_page to rewrite docs/language.md";
}

TEST(Camera, takesAllItsCommands) {
  const Scene scene =
      scene_of(light + ball +
               "background .1 .2 .3\nfov 45.5\neye 1 2 3\nuvw 1 0 0 0 0 1 0 -1 0\nlens .25 6\n"
               "shutter .25 .75\nrays_per_pixel 64\nimage_size 640 480\nsampler sobol\nseed 4294967295\n"
               "max_depth 3\nreflection_rays 1\ntransmission_rays 1\nshadow_rays 1\n");
  EXPECT_EQ(scene.background, (Vec3{.1, .2, .3}));
  EXPECT_EQ(scene.camera.fov_degrees, 45.5);
  EXPECT_EQ(scene.camera.eye, (Vec3{1, 2, 3}));
  EXPECT_EQ(scene.camera.right, (Vec3{1, 0, 0}));
  EXPECT_EQ(scene.camera.up, (Vec3{0, 0, 1}));
  EXPECT_EQ(scene.camera.back, (Vec3{0, -1, 0}));
  EXPECT_EQ(scene.camera.lens_radius, .25);
  EXPECT_EQ(scene.camera.focus_distance, 6);
  EXPECT_EQ(scene.camera.shutter_open, .25);
  EXPECT_EQ(scene.camera.shutter_close, .75);
  EXPECT_EQ(scene.settings.rays_per_pixel, 64);
  EXPECT_EQ(scene.settings.width, 640);
  EXPECT_EQ(scene.settings.height, 480);
  EXPECT_EQ(scene.settings.pattern, Pattern::sobol);
  EXPECT_EQ(scene.settings.seed, 4294967295u);
  EXPECT_EQ(scene.settings.max_depth, 3);
  EXPECT_EQ(scene_of(light + ball + "sampler random").settings.pattern, Pattern::random);
  EXPECT_EQ(scene_of(light + ball + "lens 0 0").camera.lens_radius, 0);
}

TEST(Camera, takesTheLensOfTheLecture) {
  const Camera camera = scene_of(light + ball + "fov 45\ncamera_lens .05 2 3\n").camera;
  EXPECT_EQ(camera.lens_radius, .0125);
  EXPECT_EQ(camera.focus_distance, 3);
  EXPECT_EQ(camera.focal_length, .05);
  EXPECT_EQ(camera.f_number, 2);
  EXPECT_EQ(camera.fov_degrees, 45);
}

TEST(Camera, hasTheLaterOfTwoLenses) {
  const Camera by_radius = scene_of(light + ball + "camera_lens .05 2 3\nlens .25 6\n").camera;
  EXPECT_EQ(by_radius.lens_radius, .25);
  EXPECT_EQ(by_radius.focus_distance, 6);
  EXPECT_EQ(by_radius.focal_length, 0);
  EXPECT_EQ(by_radius.f_number, 0);
  const Camera pinhole = scene_of(light + ball + "camera_lens .05 2 3\nlens 0 0\n").camera;
  EXPECT_EQ(pinhole.lens_radius, 0);
  EXPECT_EQ(pinhole.f_number, 0);
  for (const std::string before : {"lens .25 6\n", "lens 0 0\n", "camera_lens 4 8 9\n"}) {
    const Camera camera = scene_of(light + ball + before + "camera_lens 1 4 5\n").camera;
    EXPECT_EQ(camera.lens_radius, .125);
    EXPECT_EQ(camera.focus_distance, 5);
    EXPECT_EQ(camera.focal_length, 1);
    EXPECT_EQ(camera.f_number, 4);
  }
}

// Two pictures of one file: each has the lens that is set at its line.
TEST(Camera, keepsTheLensOfAPictureTaken) {
  const SceneFile file = read(light + ball + "camera_lens 1 4 5\nrender\nlens .25 6\nrender\n");
  const std::vector<Picture> list = pictures(file);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].scene->camera.f_number, 4);
  EXPECT_EQ(list[1].scene->camera.f_number, 0);
}

TEST(Camera, hasTheDefaultsOfTheLanguage) {
  const Scene scene = scene_of(light + ball);
  EXPECT_EQ(scene.background, (Vec3{}));
  EXPECT_EQ(scene.camera.fov_degrees, 60);
  EXPECT_EQ(scene.camera.lens_radius, 0);
  EXPECT_EQ(scene.camera.shutter_open, 0);
  EXPECT_EQ(scene.camera.shutter_close, 1);
  EXPECT_EQ(scene.settings.rays_per_pixel, 1);
  EXPECT_EQ(scene.settings.width, 300);
  EXPECT_EQ(scene.settings.height, 300);
  EXPECT_EQ(scene.settings.pattern, default_pattern);
  EXPECT_EQ(scene.settings.max_depth, 8);
}

TEST(Camera, isNotMovedByTheMatrix) {
  const Scene scene = scene_of("translate 5 5 5\neye 1 2 3\nlight 1 1 1 1 1 1\n" + ball);
  EXPECT_EQ(scene.camera.eye, (Vec3{1, 2, 3}));
  EXPECT_EQ(std::get<PointLight>(scene.lights[0]).position, (Vec3{1, 1, 1}));
}

TEST(Lights, areOfFourKinds) {
  const Scene scene = scene_of(ball +
                               "light 1 2 3 .4 .5 .6\npoint_light 7 8 9 .1 .2 .3\n"
                               "disk_light 1 2 3 .9 0 -1 0 .8 .7 .6\nspotlight 1 2 3 0 -1 0 20 30 1 .5 .25\n"
                               "quad_light 1 2 3 .4 0 .1 0 .2 -.3 .8 .7 .6\n");
  ASSERT_EQ(scene.lights.size(), 5u);
  EXPECT_EQ(std::get<PointLight>(scene.lights[0]).color, (Vec3{.4, .5, .6}));
  EXPECT_EQ(std::get<PointLight>(scene.lights[1]).position, (Vec3{7, 8, 9}));
  const auto& disk = std::get<DiskLight>(scene.lights[2]);
  EXPECT_EQ(disk.center, (Vec3{1, 2, 3}));
  EXPECT_EQ(disk.radius, .9);
  EXPECT_EQ(disk.direction, (Vec3{0, -1, 0}));
  EXPECT_EQ(disk.color, (Vec3{.8, .7, .6}));
  const auto& spot = std::get<SpotLight>(scene.lights[3]);
  EXPECT_EQ(spot.direction, (Vec3{0, -1, 0}));
  EXPECT_EQ(spot.inner_degrees, 20);
  EXPECT_EQ(spot.outer_degrees, 30);
  EXPECT_EQ(spot.color, (Vec3{1, .5, .25}));
  const auto& quad = std::get<QuadLight>(scene.lights[4]);
  EXPECT_EQ(quad.center, (Vec3{1, 2, 3}));
  EXPECT_EQ(quad.u, (Vec3{.4, 0, .1}));
  EXPECT_EQ(quad.v, (Vec3{0, .2, -.3}));
  EXPECT_EQ(quad.color, (Vec3{.8, .7, .6}));
}

TEST(Lenient, skipsCommandsOfOtherProgramsWithAWarning) {
  const std::string text = light + ball + "caustic_photons 100 5 2\nqwertzuiop 1 2\n";
  EXPECT_EQ(told(text),
            "s.cli:3:1: error: `caustic_photons` is a command that only other programs know\n"
            "  caustic_photons 100 5 2\n  ^~~~~~~~~~~~~~~\n  --lenient skips such lines with a warning\n"
            "s.cli:4:1: error: unknown command `qwertzuiop`\n  qwertzuiop 1 2\n  ^~~~~~~~~~\n");
  const SceneFile file = read(text, {.lenient = true});
  EXPECT_EQ(told(file),
            "s.cli:3:1: warning: `caustic_photons` is not a command of this program; the line is skipped\n"
            "  caustic_photons 100 5 2\n  ^~~~~~~~~~~~~~~\n"
            "s.cli:4:1: warning: `qwertzuiop` is not a command of this program; the line is skipped\n"
            "  qwertzuiop 1 2\n  ^~~~~~~~~~\n");
  EXPECT_EQ(pictures(file).size(), 1u);
}

TEST(Lenient, stillRefusesAMisspeltCommand) {
  EXPECT_EQ(told(light + "spere 1 0 0 -4\n", {.lenient = true}),
            "s.cli:2:1: error: unknown command `spere`\n  spere 1 0 0 -4\n  ^~~~~\n  did you mean `sphere`?\n");
}

}  // namespace
}  // namespace penumbra
