// The lens table of `check` against numbers worked out by hand. With F = 1, n = 2 and P = 5 the lens has the radius
// 1/4 and V_P = 5/4; with 90 degrees over 300 pixels, r S / (2 D tan(fov/2)) = 150 r / D.
#include "app/check/lens_table.hpp"

#include "support.hpp"

namespace penumbra {
namespace {

const std::string camera = "fov 90\ncamera_lens 1 2 5\n";

std::string table_of(const std::string& text) { return lens_table(scene_of(light + text)); }

TEST(LensTable, hasAllQuantitiesOfTheLecture) {
  EXPECT_EQ(table_of(camera + "image_size 300 400\n"
                              "sphere .5 9 0 -2\n"                // off the axis: D is not the distance from the eye
                              "box -1 -1 -11 1 1 -9\n"            // D = 10
                              "cylinder 1 0 -5 0 3\n"             // in focus
                              "sphere .1 0 0 -.5\n"               // nearer than F: its image is on its own side
                              "sphere .1 0 0 -1\n"                // at F: an image at infinity
                              "sphere 1 0 0 4\nsphere 1 7 0 0\n"  // behind, and beside
                              "sphere 1 0 0 -15\nmoving_object 0 0 -10\n"  // D = 20 half way through the shutter
                              "begin_list\nend_list\n"),
            "  lens       F 1, n 2, aperture F/n 0.5, focus P 5, image plane V_P 1.25\n"
            "             D: distance along the view of the centre of each object's bounding box at time 0.5\n"
            "             object                         D         V_D           r           C r in pixels\n"
            "             1 sphere                       2           2        0.15      0.1875       11.25\n"
            "             2 box                         10     1.11111        0.25      0.0625        3.75\n"
            "             3 cylinder                     5        1.25           0           0           0\n"
            "             4 sphere                     0.5          -1       0.225       1.125        67.5\n"
            "             5 sphere                       1         inf         0.2         0.5          30\n"
            "             6 sphere                      -4  behind the eye\n"
            "             7 sphere                       0  behind the eye\n"
            "             8 sphere                      20     1.05263        0.75     0.09375       5.625\n"
            "             9 group of 0                   -  empty\n");
}

TEST(LensTable, knowsLessOfAPlainLens) {
  EXPECT_EQ(table_of("fov 90\nlens .25 5\nsphere .5 0 0 -2\nsphere .5 0 0 1\n"),
            "  lens       F and n unknown, aperture 0.5, focus P 5\n"
            "             D: distance along the view of the centre of each object's bounding box at time 0.5\n"
            "             object                         D           r r in pixels\n"
            "             1 sphere                       2        0.15       11.25\n"
            "             2 sphere                      -1  behind the eye\n");
}

TEST(LensTable, isNotThereForAPinhole) {
  EXPECT_EQ(table_of(ball), "");
  EXPECT_EQ(table_of("camera_lens 1 2 5\nlens 0 5\n" + ball), "");
}

TEST(LensTable, measuresAlongTheViewFromTheEye) {
  // From (1, 2, 3) along +x, with vectors that are not unit vectors.
  const std::string text = table_of(camera + "eye 1 2 3\nuvw 0 0 2 0 3 0 -4 0 0\nsphere 1 3 9 -7\n");
  EXPECT_NE(text.find(" 1 sphere                       2           2        0.15 "), std::string::npos) << text;
}

TEST(LensTable, hasTheTimeOfTheShutter) {
  const std::string text = table_of(camera + "shutter .5 .7\nsphere 1 0 0 -4\nmoving_object 0 0 -10\n");
  EXPECT_NE(text.find(" at time 0.6\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" 1 sphere                      10     1.11111 "), std::string::npos) << text;
}

// What a bounding box encloses: a run of triangles, a group and its moving members, nested instances, placed shapes.
TEST(LensTable, findsTheCentreOfEveryKindOfObject) {
  const std::string text =
      table_of(camera +
               "begin\nvertex 0 0 -4\nvertex 1 0 -6\nvertex 0 1 -16\nend\n"  // 4 to 16
               "begin_list\nsphere 1 0 0 -2\nsphere 1 0 0 -5\nmoving_object 0 0 -2\nend_list\n"
               "moving_object 0 0 -1\n"                                       // 1 to 7, and farther by a half
               "push\ntranslate 0 0 -8\nscale 1 1 2\nsphere 1 0 0 -1\npop\n"  // an ellipsoid round -10
               "begin_list\nbox 0 0 0 1 1 2\nsphere 1 0 0 5\nend_list\nnamed_object inner\n"  // 0 to 6
               "push\nscale 2 2 2\ninstance inner\nnamed_object outer\npop\n"                 // 0 to 12
               "push\nrotatey 180\ntranslate 0 0 14\ninstance outer\npop\n"                   // -14 to -26
               "begin\nvertex 0 0 -3\nvertex 1 0 -3\nvertex 1 1 -3\nvertex 0 1 -3\nend\n");
  for (const std::string row : {" 1 triangle                    10 ", " 2 group of 2                 4.5 ",
                                " 3 sphere                      10 ", " 4 instance                    20 ",
                                " 5 2 triangles                  3 "}) {
    EXPECT_NE(text.find(row), std::string::npos) << row << "\n" << text;
  }
}

TEST(LensTable, endsAfterFiftyObjects) {
  std::string spheres;
  for (int i = 0; i < 50; i++) spheres += ball;
  EXPECT_EQ(table_of(camera + spheres).find("more"), std::string::npos);
  const std::string text = table_of(camera + spheres + ball + ball);
  EXPECT_NE(text.find(" 50 sphere"), std::string::npos);
  EXPECT_EQ(text.find(" 51 sphere"), std::string::npos);
  EXPECT_NE(text.find("             ... and 2 more\n"), std::string::npos);
}

// The two relations between the lecture's quantities.
TEST(LensTable, agreesWithItself) {
  for (const double f : {.02, 1.0}) {
    for (const double n : {1.4, 8.0}) {
      for (const double p : {1.5, 40.0}) {
        const Scene scene = scene_of(light + ball + "camera_lens " + std::to_string(f) + " " + std::to_string(n) + " " +
                                     std::to_string(p) + "\n");
        const double v_p = image_plane_distance(scene.camera);
        EXPECT_NEAR(1 / v_p + 1 / p, 1 / f, 1e-9 / f);  // the equation of the thin lens
        for (const double d : {1.2, 3.0, 100.0}) {
          const LensBlur blur = lens_blur(scene, d);
          EXPECT_NEAR(1 / blur.image_distance + 1 / d, 1 / f, 1e-9 / f);
          EXPECT_NEAR(blur.circle_of_confusion, 2 * blur.radius * v_p / d, 1e-12);
          // The width, at the image plane, of the cone of light behind the lens: the aperture there, a point at V_D.
          EXPECT_NEAR(blur.circle_of_confusion, f / n * std::abs(blur.image_distance - v_p) / blur.image_distance,
                      1e-9);
        }
      }
    }
  }
}

}  // namespace
}  // namespace penumbra
