// The text of every error and warning about a command. Files, meshes and limits have their own tests.
#include "support.hpp"

namespace penumbra {
namespace {

// The hint of every radius of a sphere that is out of range.
const std::string order_of_2018 =
    "  if this file has the order of 2018 (`sphere x y z radius`), --course=2018, or `course 2018` in the first line, "
    "reads that order\n";

struct Case {
  std::string text;
  std::string told;
};

void expect_told(const std::vector<Case>& cases, const std::string& before = "") {
  for (const Case& c : cases) {
    const SceneFile file = read(before + c.text);
    EXPECT_EQ(told(file), c.told) << c.text;
    EXPECT_EQ(file.actions.empty(), has_error(file.diagnostics)) << c.text;
  }
}

TEST(Errors, aboutUnknownCommands) {
  expect_told({
      {"spere 1 0 0 -4",
       "s.cli:1:1: error: unknown command `spere`\n  spere 1 0 0 -4\n  ^~~~~\n  did you mean `sphere`?\n"},
      {"  Translate 1 0 0",
       "s.cli:1:3: error: unknown command `Translate`\n    Translate 1 0 0\n    ^~~~~~~~~\n  did you mean "
       "`translate`?\n"},
      {"xyzzy", "s.cli:1:1: error: unknown command `xyzzy`\n  xyzzy\n  ^~~~~\n"},
      {"\x01\x02", "s.cli:1:1: error: unknown command `??`\n  ??\n  ^~\n"},
  });
}

TEST(Errors, aboutTheNumberOfArguments) {
  expect_told({
      {"sphere 1 0 0", "s.cli:1:1: error: `sphere` takes 4 numbers: radius x y z; found 3\n  sphere 1 0 0\n  ^~~~~~\n"},
      {"sphere 1 0 0 -4 5 6",
       "s.cli:1:17: error: `sphere` takes 4 numbers: radius x y z; found 6\n  sphere 1 0 0 -4 5 6\n                  "
       "^\n"},
      {"fov", "s.cli:1:1: error: `fov` takes 1 number: degrees; found 0\n  fov\n  ^~~\n"},
      {"push 1", "s.cli:1:6: error: `push` takes nothing; found 1\n  push 1\n       ^\n"},
      {"write", "s.cli:1:1: error: `write` takes a file name; found 0\n  write\n  ^~~~~\n"},
      {"instance a b", "s.cli:1:12: error: `instance` takes a name; found 2\n  instance a b\n             ^\n"},
      {"surface 1 1 1 1",
       "s.cli:1:1: error: `surface` takes 3 numbers: dr dg db, or 11 numbers: dr dg db ar ag ab sr sg sb spec_pow "
       "k_refl; "
       "found 4\n  surface 1 1 1 1\n  ^~~~~~~\n"},
  });
}

TEST(Errors, aboutTheKindOfArguments) {
  expect_told({
      {"eye 1 two 3", "s.cli:1:7: error: `y` of `eye` has to be a number; found `two`\n  eye 1 two 3\n        ^~~\n"},
      {"eye 1 nan 3", "s.cli:1:7: error: `y` of `eye` has to be a number; found `nan`\n  eye 1 nan 3\n        ^~~\n"},
      {"eye 1 -inf 3",
       "s.cli:1:7: error: `y` of `eye` has to be a number; found `-inf`\n  eye 1 -inf 3\n        ^~~~\n"},
      {"eye 1 1e40 3", "s.cli:1:7: error: the number `1e40` is too large\n  eye 1 1e40 3\n        ^~~~\n"},
      {"eye a b 3",
       "s.cli:1:5: error: `x` of `eye` has to be a number; found `a`\n  eye a b 3\n      ^\n"
       "s.cli:1:7: error: `y` of `eye` has to be a number; found `b`\n  eye a b 3\n        ^\n"},
      {"begin\nvertex 1 2 3x\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nend\n",
       "s.cli:2:12: error: `z` of `vertex` has to be a number; found `3x`\n  vertex 1 2 3x\n             ^~\n"},
  });
}

TEST(Errors, aboutTheRangeOfArguments) {
  expect_told({
      {"sphere 0 0 0 0",
       "s.cli:1:8: error: `radius` of `sphere` has to be greater than 0; found `0`\n  sphere 0 0 0 0\n         ^\n" +
           order_of_2018},
      {"sphere -1 0 0 0",
       "s.cli:1:8: error: `radius` of `sphere` has to be greater than 0; found `-1`\n  sphere -1 0 0 0\n         ^~\n" +
           order_of_2018},
      {"sphere 1e-60 0 0 0",
       "s.cli:1:8: error: `radius` of `sphere` has to be greater than 0; found `1e-60`\n  sphere 1e-60 0 0 0\n         "
       "^~~~~\n" +
           order_of_2018},
      {"moving_sphere -1 0 0 0 0 0 0",
       "s.cli:1:15: error: `radius` of `moving_sphere` has to be greater than 0; found `-1`\n"
       "  moving_sphere -1 0 0 0 0 0 0\n                ^~\n"},
      {"cylinder 0 0 0 0 1",
       "s.cli:1:10: error: `radius` of `cylinder` has to be greater than 0; found `0`\n  cylinder 0 0 0 0 1\n          "
       " ^\n"},
      {"hollow_cylinder 0 0 0 0 1",
       "s.cli:1:17: error: `radius` of `hollow_cylinder` has to be greater than 0; found `0`\n"
       "  hollow_cylinder 0 0 0 0 1\n                  ^\n"},
      {"cone 0 0 0 -1 1",
       "s.cli:1:12: error: `h` of `cone` has to be greater than 0; found `-1`\n  cone 0 0 0 -1 1\n             ^~\n"},
      {"cone 0 0 0 1 0",
       "s.cli:1:14: error: `k` of `cone` has to be greater than 0; found `0`\n  cone 0 0 0 1 0\n               ^\n"},
      {"cone 0 0 0 1e20 1e20", "s.cli:1:1: error: this cone is too large at its top\n  cone 0 0 0 1e20 1e20\n  ^~~~\n"},
      {"cone 0 3e38 0 3e38 .1",
       "s.cli:1:1: error: this cone is too large at its top\n  cone 0 3e38 0 3e38 .1\n  ^~~~\n"},
      {"disk_light 0 0 0 -1 0 1 0 1 1 1",
       "s.cli:1:18: error: `radius` of `disk_light` has to be 0 or more; found `-1`\n"
       "  disk_light 0 0 0 -1 0 1 0 1 1 1\n                   ^~\n"},
      {"fov 180",
       "s.cli:1:5: error: `degrees` of `fov` has to be greater than 0 and less than 180; found `180`\n  fov 180\n      "
       "^~~\n"},
      {"fov 0",
       "s.cli:1:5: error: `degrees` of `fov` has to be greater than 0 and less than 180; found `0`\n  fov 0\n      "
       "^\n"},
      {"rays_per_pixel 0",
       "s.cli:1:16: error: `n` of `rays_per_pixel` has to be a whole number from 1 to 16777216; found `0`\n"
       "  rays_per_pixel 0\n                 ^\n"},
      {"rays_per_pixel -4",
       "s.cli:1:16: error: `n` of `rays_per_pixel` has to be a whole number from 1 to 16777216; found `-4`\n"
       "  rays_per_pixel -4\n                 ^~\n"},
      {"rays_per_pixel 2.5",
       "s.cli:1:16: error: `n` of `rays_per_pixel` has to be a whole number from 1 to 16777216; found `2.5`\n"
       "  rays_per_pixel 2.5\n                 ^~~\n"},
      {"lens -1 5", "s.cli:1:6: error: `radius` of `lens` has to be 0 or more; found `-1`\n  lens -1 5\n       ^~\n"},
      {"lens .1 0",
       "s.cli:1:9: error: `dist` of `lens` has to be greater than 0; found `0`\n  lens .1 0\n          ^\n"},
      {"max_depth 101",
       "s.cli:1:11: error: `n` of `max_depth` has to be a whole number from 0 to 100; found `101`\n  max_depth 101\n   "
       "         ^~~\n"},
      {"seed -1",
       "s.cli:1:6: error: `n` of `seed` has to be a whole number from 0 to 4294967295; found `-1`\n  seed -1\n       "
       "^~\n"},
      {"rect 0 0 1.5 2",
       "s.cli:1:10: error: `x1` of `rect` has to be a whole number; found `1.5`\n  rect 0 0 1.5 2\n           ^~~\n"},
      {"spotlight 0 0 0 0 -1 0 20 190 1 1 1",
       "s.cli:1:27: error: `outer` of `spotlight` has to be from 0 to 180; found `190`\n"
       "  spotlight 0 0 0 0 -1 0 20 190 1 1 1\n                            ^~~\n"},
      {"glossy 1 1 1 1 1 1 -2 0 0",
       "s.cli:1:20: error: `spec_pow` of `glossy` has to be 0 or more; found `-2`\n"
       "  glossy 1 1 1 1 1 1 -2 0 0\n                     ^~\n"},
      {"glossy 1 1 1 1 1 1 2 0 -.1",
       "s.cli:1:24: error: `gloss_radius` of `glossy` has to be 0 or more; found `-.1`\n"
       "  glossy 1 1 1 1 1 1 2 0 -.1\n                         ^~~\n"},
      {"shiny 1 1 1 1 1 1 1 1 1 2 0 1 0",
       "s.cli:1:31: error: `index` of `shiny` has to be greater than 0 where k_trans is not 0; found `0`\n"
       "  shiny 1 1 1 1 1 1 1 1 1 2 0 1 0\n                                ^\n"},
  });
}

TEST(Errors, aboutTheCamera) {
  expect_told({
      {"uvw 1 0 0 0 1 0 1 1 0",
       "s.cli:1:1: error: the three vectors of `uvw` lie in one plane\n  uvw 1 0 0 0 1 0 1 1 0\n  ^~~\n"},
      {"shutter 1 .5",
       "s.cli:1:11: error: the shutter closes before it opens: `close` has to be `open` or more\n  shutter 1 .5\n      "
       "      ^~\n"},
      {"sampler sobbol",
       "s.cli:1:9: error: there is no sampler `sobbol`; there are regular, random, jittered, multijittered, "
       "poisson, halton, sobol, bluenoise\n  sampler sobbol\n          "
       "^~~~~~\n"
       "  did you mean `sobol`?\n"},
      {"reflection_rays 0",
       "s.cli:1:17: error: `n` of `reflection_rays` has to be a whole number from 1 to 65536; found `0`\n"
       "  reflection_rays 0\n                  ^\n"},
      {"camera_lens 0 2 3",
       "s.cli:1:13: error: `F` of `camera_lens` has to be greater than 0; found `0`\n  camera_lens 0 2 3\n"
       "              ^\n"},
      {"camera_lens .05 -2 3",
       "s.cli:1:17: error: `n` of `camera_lens` has to be greater than 0; found `-2`\n  camera_lens .05 -2 3\n"
       "                  ^~\n"},
      {"camera_lens .05 2 .05",
       "s.cli:1:19: error: `P` of `camera_lens` has to be greater than `F`; found `.05`\n"
       "  camera_lens .05 2 .05\n                    ^~~\n"},
      {"camera_lens .05 2 -3",
       "s.cli:1:19: error: `P` of `camera_lens` has to be greater than `F`; found `-3`\n"
       "  camera_lens .05 2 -3\n                    ^~\n"},
      {"camera_lens 1e20 1e-20 1e30",
       "s.cli:1:18: error: the aperture F/n of `camera_lens` is too large\n"
       "  camera_lens 1e20 1e-20 1e30\n                   ^~~~~\n"},
      {"spotlight 0 0 0 0 -1 0 30 20 1 1 1",
       "s.cli:1:27: error: `outer` of `spotlight` has to be `inner` or more\n"
       "  spotlight 0 0 0 0 -1 0 30 20 1 1 1\n                            ^~\n"},
      {"spotlight 0 0 0 0 0 0 30 40 1 1 1",
       "s.cli:1:17: error: the direction of `spotlight` has no length\n"
       "  spotlight 0 0 0 0 0 0 30 40 1 1 1\n                  ^\n"},
      {"disk_light 0 0 0 1 0 0 0 1 1 1",
       "s.cli:1:20: error: the direction of `disk_light` has no length\n"
       "  disk_light 0 0 0 1 0 0 0 1 1 1\n                     ^\n"},
      {"quad_light 0 0 0 .1 .2 .3 -.3 -.6 -.9 1 1 1",
       "s.cli:1:18: error: the two half edges of `quad_light` lie on one line\n"
       "  quad_light 0 0 0 .1 .2 .3 -.3 -.6 -.9 1 1 1\n                   ^~\n"},
      {"quad_light 0 0 0 0 0 0 1 0 0 1 1 1",
       "s.cli:1:18: error: the two half edges of `quad_light` lie on one line\n"
       "  quad_light 0 0 0 0 0 0 1 0 0 1 1 1\n                   ^\n"},
      {"quad_light 0 0 0 1 0 0 0 0 0 1 1 1",
       "s.cli:1:18: error: the two half edges of `quad_light` lie on one line\n"
       "  quad_light 0 0 0 1 0 0 0 0 0 1 1 1\n                   ^\n"},
  });
}

TEST(Errors, aboutPolygons) {
  expect_told({
      {"vertex 1 2 3\nvertex 1 2 3\nend\n",
       "s.cli:1:1: error: `vertex` outside `begin` and `end`\n  vertex 1 2 3\n  ^~~~~~\n"},
      {"end\n", "s.cli:1:1: error: `end` without a `begin` before it\n  end\n  ^~~\n"},
      {"begin\nvertex 1 2 3\nvertex 1 2 4\nend\n",
       "s.cli:4:1: error: a polygon needs at least three `vertex` lines; found 2\n  end\n  ^~~\n"},
      {"begin\nvertex 1 2 3\nbegin\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nend\n",
       "s.cli:3:1: error: `begin` while the polygon begun on line 1 is still open\n  begin\n  ^~~~~\n"},
      {"begin\nvertex 1 2 3\n",
       "s.cli:1:1: error: this polygon is left open: there is no `end` after it\n  begin\n  ^~~~~\n"},
      {"begin\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nsphere 1 0 0 0\nend\n",
       "s.cli:5:1: error: `sphere` may not stand between `begin` and `end`; the polygon begun on line 1 is still open\n"
       "  sphere 1 0 0 0\n  ^~~~~~\n"},
      {"begin_list\n" + triangle + "end\n" + "end_list\n",
       "s.cli:7:1: error: `end` without a `begin` before it\n  end\n  ^~~\n  did you mean `end_list`?\n"},
      {"begin_accel\n" + triangle + "end\n" + "end_accel\n",
       "s.cli:7:1: error: `end` without a `begin` before it\n  end\n  ^~~\n  did you mean `end_accel`?\n"},
  });
  for (const char* command : {"write f", "render", "box 0 0 0 1 1 1", "cylinder 1 0 0 0 1", "hollow_cylinder 1 0 0 0 1",
                              "cone 0 0 0 1 1", "moving_sphere 1 0 0 0 1 1 1", "mesh a.obj", "moving_object 1 1 1",
                              "begin_list", "begin_accel", "named_object n", "instance n", "end_list", "end_accel"}) {
    EXPECT_NE(told("begin\n" + std::string(command) + "\n").find("may not stand between"), std::string::npos)
        << command;
  }
}

TEST(Errors, aboutGroupsAndNames) {
  expect_told({
      {"end_list\n", "s.cli:1:1: error: `end_list` without a `begin_list` before it\n  end_list\n  ^~~~~~~~\n"},
      {"end_accel\n", "s.cli:1:1: error: `end_accel` without a `begin_accel` before it\n  end_accel\n  ^~~~~~~~~\n"},
      {"begin_list\n" + ball,
       "s.cli:1:1: error: this group is left open: there is no `end_list` or `end_accel` for it\n  begin_list\n  "
       "^~~~~~~~~~\n"},
      {"begin_accel\n" + ball,
       "s.cli:1:1: error: this group is left open: there is no `end_accel` for it\n  begin_accel\n  ^~~~~~~~~~~\n"},
      {"moving_object 1 0 0\n",
       "s.cli:1:1: error: there is no object before it to move\n  moving_object 1 0 0\n  ^~~~~~~~~~~~~\n"},
      {"named_object a\n",
       "s.cli:1:1: error: there is no object before it to name\n  named_object a\n  ^~~~~~~~~~~~\n"},
      {ball + "named_object a\nmoving_object 1 0 0\ninstance a\n",
       "s.cli:3:1: error: there is no object before it to move\n  moving_object 1 0 0\n  ^~~~~~~~~~~~~\n"},
      {ball + ball + "named_object a\nnamed_object b\ninstance a\n",
       "s.cli:4:1: error: there is no object before it to name\n  named_object b\n  ^~~~~~~~~~~~\n"},
      {ball + "begin_list\nmoving_object 1 0 0\nend_list\n",
       "s.cli:2:1: warning: this group is empty\n  begin_list\n  ^~~~~~~~~~\n"
       "s.cli:3:1: error: there is no object before it to move\n  moving_object 1 0 0\n  ^~~~~~~~~~~~~\n"},
      {ball + "named_object ball\n" + ball + "named_object ball\ninstance ball\n",
       "s.cli:4:14: error: the name `ball` is used twice; first at s.cli:2\n  named_object ball\n               "
       "^~~~\n"},
      {ball + "named_object ball\ninstance bal\n",
       "s.cli:3:10: error: there is no object with the name `bal`\n  instance bal\n           ^~~\n  did you mean "
       "`ball`?\n"},
      {"instance x", "s.cli:1:10: error: there is no object with the name `x`\n  instance x\n           ^\n"},
  });
}

TEST(Errors, aboutTheMatrix) {
  expect_told({
      {"pop\n", "s.cli:1:1: error: `pop` without a `push` before it\n  pop\n  ^~~\n"},
      {"scale 1 0 1\n",
       "s.cli:1:9: error: a `scale` by zero flattens everything after it\n  scale 1 0 1\n          ^\n"},
      {"scale 1 1 -0.0\n",
       "s.cli:1:11: error: a `scale` by zero flattens everything after it\n  scale 1 1 -0.0\n            ^~~~\n"},
      {"rotate 30 0 0 0\n",
       "s.cli:1:11: error: the axis of `rotate` has no length\n  rotate 30 0 0 0\n            ^\n"},
      {"scale 1e-20 1e-20 1e-20\nscale 1e-20 1e-20 1e-20\nsphere 1 0 0 0\n",
       "s.cli:3:1: error: the current matrix is singular: it flattens the shape, or shrinks it to nothing\n"
       "  sphere 1 0 0 0\n  ^~~~~~\n"},
      {"scale 1e30 1 1\nscale 1e30 1 1\nbox 0 0 0 1 1 1\n",
       "s.cli:3:1: error: the current matrix has become too large\n  box 0 0 0 1 1 1\n  ^~~\n"},
      {"scale 1e30 1 1\nscale 1e30 1 1\n" + triangle,
       "s.cli:3:1: error: the current matrix has become too large\n  begin\n  ^~~~~\n"},
      {"scale 1e30 1 1\nbegin\nvertex 1e30 0 0\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 1 1\nend\n",
       "s.cli:3:1: error: the current matrix moves this vertex too far away\n  vertex 1e30 0 0\n  ^~~~~~\n"},
      {"sphere 1 0 0 0\nmoving_object 3e38 0 0\nmoving_object 3e38 0 0\n",
       "s.cli:3:1: error: the motion has become too large\n  moving_object 3e38 0 0\n  ^~~~~~~~~~~~~\n"},
  });
  std::string text;
  for (int i = 0; i < 9; i++) text += "scale 1e38 1 1\n";
  EXPECT_EQ(told(text), "s.cli:9:1: error: the current matrix has become too large\n  scale 1e38 1 1\n  ^~~~~\n");
}

TEST(Warnings, aboutWhatIsOdd) {
  expect_told({
      {ball, "s.cli: warning: there is no light in this picture\n"},
      {light, "s.cli: warning: there is no object in this picture\n"},
      {light + ball + "uvw 1 0 0 0 1 0 0 0 -1\n",
       "s.cli:3:1: warning: the vectors of `uvw` are left-handed: the picture is mirrored\n"
       "  uvw 1 0 0 0 1 0 0 0 -1\n  ^~~\n"},
      {light + ball + "uvw 1 0 0 .1 1 0 0 0 3\n",
       "s.cli:3:1: warning: the vectors of `uvw` are not at right angles: the picture is sheared\n"
       "  uvw 1 0 0 .1 1 0 0 0 3\n  ^~~\n"},
      {light + ball + "uvw .71 0 -.70 0 1 0 .71 0 .7\nuvw 2e20 0 0 0 1e-30 0 0 0 1\n", ""},
      {ball + "write a.png\n", "s.cli:2:1: warning: there is no light in this picture\n  write a.png\n  ^~~~~\n"},
      {light + ball + "push\n",
       "s.cli:3:1: warning: this `push` is left open: there is no `pop` for it\n  push\n  ^~~~\n"},
      {light + ball + ball + "named_object a\n",
       "s.cli:4:14: warning: `a` is never used: there is no `instance` of it\n  named_object a\n               ^\n"},
      {light + ball + "render\n" + ball + ball,
       "s.cli:4:1: warning: nothing from here on is in any picture: the last one is taken before this line\n"
       "  sphere 1 0 0 -4\n  ^~~~~~\n"},
      {light + ball + "render\nrect 0 0 5 5\n",
       "s.cli:4:1: warning: nothing from here on is in any picture: the last one is taken before this line\n"
       "  rect 0 0 5 5\n  ^~~~\n"},
      {light + ball + "render\n" + ball + "render\n", ""},
      {light + ball + "begin_list\nend_list\n",
       "s.cli:3:1: warning: this group is empty\n  begin_list\n  ^~~~~~~~~~\n"},
      {light + "begin_accel\n" + ball + "end_list\n",
       "s.cli:4:1: warning: `end_list` ends the `begin_accel` on line 2\n  end_list\n  ^~~~~~~~\n"},
      {light + "cylinder 1 0 0 2 2\n",
       "s.cli:2:16: warning: this cylinder has no height\n  cylinder 1 0 0 2 2\n                 ^\n"},
      {light + "wood\n" + ball + "marble\n" + ball + "stone\n" + ball + "wood\n" + ball, ""},
      {light + "begin_list\n" + ball + "end_accel\n", ""},
      {"rect 0 0 5 5\n", ""},
  });
}

}  // namespace
}  // namespace penumbra
