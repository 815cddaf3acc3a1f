#include "app/check/check_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "geometry/precision.hpp"
#include "support.hpp"

namespace penumbra {
namespace {

struct Checked {
  int code = 0;
  std::string out, errors;
};

Checked check(const CheckOptions& options) {
  Checked result;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  result.code = check_command(options);
  result.out = testing::internal::GetCapturedStdout();
  result.errors = testing::internal::GetCapturedStderr();
  return result;
}

// The warning about a scene.
std::string warning_of(const std::string& text) { return precision_warning(scene_of(text)); }

TEST(Check, warnsOfWhatSinglePrecisionCannotHold) {
  const std::string room = "light 0 9 0 1 1 1\nbox -20 -1 -20 20 0 20\n" + ball;
  for (const char* near :
       {"", "translate 100 0 0\n", "translate 0 0 -10000\n", "scale 1e-9 1e-9 1e-9\n", "scale 1e9 1e9 1e9\n"}) {
    EXPECT_EQ(warning_of(near + room), "") << near;
  }
  EXPECT_EQ(warning_of("translate 0 1e6 0\n" + room),
            "the sphere at 0 1e+06 -4 is 2 wide, but numbers of single precision, in which pictures are computed, are "
            "0.0625 apart there: move the scene to the origin");
  EXPECT_NE(warning_of("translate 1e8 0 0\n" + room).find("box at 1e+08"), std::string::npos);
  EXPECT_NE(warning_of("translate 1e8 0 0\n" + room).find("(and so for 1 more)"), std::string::npos);
  EXPECT_NE(warning_of(light + ball + "named_object b\ntranslate 0 0 -1e6\ninstance b\n").find("instance"),
            std::string::npos);
  EXPECT_NE(warning_of(light + "translate 1e6 0 0\n" + triangle).find("the triangles at 1e+06"), std::string::npos);
  // Fine triangles of a large mesh, and a huge floor, are no reason.
  std::string strip = light;
  for (int i = 0; i < 1000; i++) {
    strip += fmt::format("begin\nvertex {0} 0 5\nvertex {0} 1e-5 5\nvertex {1} 0 5\nend\n", i * 1e-5, (i + 1) * 1e-5);
  }
  EXPECT_EQ(warning_of(strip), "");
  EXPECT_EQ(warning_of(light + "box -1e6 -2e6 -1e6 1e6 -1 1e6\n" + ball), "");
}

TEST(Check, saysWhatIsInAScene) {
  const SceneFile file = read(
      "image_size 640 480\nrays_per_pixel 64\nsampler random\nseed 5\nfov 45\neye 0 1 2\nlens .1 4\n"
      "shutter 0 .5\nbackground .2 .4 .8\n" +
      light +
      "disk_light 0 5 0 1 0 -1 0 1 1 1\nquad_light 0 5 0 1 0 0 0 0 1 1 1 1\nspotlight 0 5 0 0 -1 0 10 20 1 1 1\n" +
      light + ball +
      "surface 1 0 0\nbox 0 0 0 1 1 1\nmoving_object 1 0 0\ncylinder 1 0 0 0 1\n"
      "hollow_cylinder 1 0 0 0 1\nbegin_list\n" +
      triangle + triangle + ball +
      "end_list\n"
      "named_object g\ninstance g\ninstance g\npush\nwrite out.png\nrender\nrect 0 0 5 5\nrender\n");
  EXPECT_EQ(
      describe(file),
      "read: s.cli\n"
      "picture 1: out.png\n"
      "  size       640 x 480\n"
      "  rays       64 per pixel, depth 8, sampler random, seed 5\n"
      "  camera     eye 0 1 2, looking along 0 0 -1, fov 45, lens of radius 0.1 focused at 4, shutter 0 to 0.5\n"
      "  background 0.2 0.4 0.8\n"
      "  lights     2 point lights, 1 disk light, 1 quad light, 1 spotlight\n"
      "  objects    2 spheres, 1 box, 2 cylinders, 2 triangles, 1 group, 1 named object, 2 instances, 1 moving object\n"
      "  surfaces   2\n"
      "  lens       F and n unknown, aperture 0.2, focus P 4\n"
      "             D: distance along the view of the centre of each object's bounding box at time 0.25\n"
      "             object                         D           r r in pixels\n"
      "             1 sphere                       6        0.05     4.82843\n"
      "             2 box                        1.5      0.0625     24.1421\n"
      "             3 cylinder                     2        0.05     14.4853\n"
      "             4 cylinder                     2        0.05     14.4853\n"
      "             5 instance                   4.5      0.0125     1.60948\n"
      "             6 instance                   4.5      0.0125     1.60948\n"
      "picture 2: named after the scene, the same scene\n"
      "picture 3: named after the scene\n"
      "  size       640 x 480\n"
      "  rays       64 per pixel, depth 8, sampler random, seed 5\n"
      "  camera     eye 0 1 2, looking along 0 0 -1, fov 45, lens of radius 0.1 focused at 4, shutter 0 to 0.5\n"
      "  background 0.2 0.4 0.8\n"
      "  lights     2 point lights, 1 disk light, 1 quad light, 1 spotlight\n"
      "  objects    2 spheres, 1 box, 2 cylinders, 2 triangles, 1 group, 1 named object, 2 instances, 1 moving object\n"
      "  surfaces   2\n"
      "  painted    1 rectangle\n"
      "  lens       F and n unknown, aperture 0.2, focus P 4\n"
      "             D: distance along the view of the centre of each object's bounding box at time 0.25\n"
      "             object                         D           r r in pixels\n"
      "             1 sphere                       6        0.05     4.82843\n"
      "             2 box                        1.5      0.0625     24.1421\n"
      "             3 cylinder                     2        0.05     14.4853\n"
      "             4 cylinder                     2        0.05     14.4853\n"
      "             5 instance                   4.5      0.0125     1.60948\n"
      "             6 instance                   4.5      0.0125     1.60948\n"
      "1 warning\n");
}

TEST(Check, countsConesToo) {
  const std::string cone = "cone 0 0 -4 1 2\n";
  EXPECT_NE(describe(read(light + cone)).find("  objects    1 cone\n"), std::string::npos);
  const std::string text = describe(read(light + "lens 1 4\n" + cone + triangle + cone + "box 0 0 0 1 1 1\n"));
  EXPECT_NE(text.find("  objects    1 box, 2 cones, 1 triangle\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" 1 cone                         4 "), std::string::npos) << text;
}

TEST(Check, hasAnExitCodeForEachCase) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("penumbra-check-test-" + std::to_string(::getpid()) + ".cli");
  std::ofstream(path) << light << ball;
  Checked result = check({.scene = path});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.errors, "");
  EXPECT_NE(result.out.find("  objects    1 sphere\n"), std::string::npos);

  std::ofstream(path) << light << ball << "torus 1 2 3\n";
  result = check({.scene = path});
  EXPECT_EQ(result.code, 65);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.errors.find(":3:1: error: `torus` is a command that only other programs know\n"), std::string::npos);
  CheckOptions lenient{.scene = path};
  lenient.picture.lenient = true;
  result = check(lenient);
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.out.find("1 warning\n"), std::string::npos);

  std::ofstream(path) << light << "translate 1e6 0 0\n" << ball;
  result = check({.scene = path});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.errors.find(path.string() + ": warning: the sphere at 1e+06 0 -4"), std::string::npos);
  EXPECT_NE(result.errors.find(path.string() + ": warning: nothing is in view"), std::string::npos);
  EXPECT_NE(result.out.find("2 warnings\n"), std::string::npos);

  std::ofstream(path) << "read no-such-file.cli\n";
  EXPECT_EQ(check({.scene = path}).code, 65);
  std::filesystem::remove(path);
  result = check({.scene = path});
  EXPECT_EQ(result.code, 66);
  EXPECT_EQ(result.errors, path.string() + ": error: cannot read this file: No such file or directory\n");
}

}  // namespace
}  // namespace penumbra
