// Numbers written as {expression}: their values, and the errors of wrong ones.
#include <cmath>
#include <numbers>

#include "support.hpp"

namespace penumbra {
namespace {

// The value of an expression at a moment.
double value_of(const std::string& expression, const Moment& moment = {}) {
  ReadOptions options;
  options.moment = moment;
  const SceneFile file = read("eye " + expression + " 0 0\n" + light + ball, options);
  EXPECT_EQ(told(file), "") << expression;
  return file.actions.empty() ? NAN : pictures(file).front().scene->camera.eye.x;
}

// The first line of the error of `eye EXPRESSION 0 0`.
std::string problem(const std::string& expression) {
  const SceneFile file = read("eye " + expression + " 0 0\n");
  EXPECT_TRUE(file.actions.empty()) << expression;
  EXPECT_EQ(file.diagnostics.size(), 1u) << expression;
  const std::string text = told(file);
  return text.substr(0, text.find('\n'));
}

TEST(Expression, isArithmetic) {
  EXPECT_EQ(value_of("{1+2*3}"), 7);
  EXPECT_EQ(value_of("{ (1 + 2) * 3 }"), 9);
  EXPECT_EQ(value_of("{-.5e1 - +2.}"), -7);
  EXPECT_EQ(value_of("{7 / 2}"), 3.5);
  EXPECT_EQ(value_of("{2^10}"), 1024);
  EXPECT_EQ(value_of("{-2^2}"), -4);
  EXPECT_EQ(value_of("{2^3^2}"), 512);
  EXPECT_EQ(value_of("{1 < 2 ? 3 : 4}"), 3);
  EXPECT_EQ(value_of("{1 >= 2 || 1 != 1 ? 3 : 4}"), 4);
  EXPECT_EQ(value_of("{2 > 1 && 1 <= 1 && 1 == 1 ? 3 : 4}"), 3);
  EXPECT_EQ(value_of("{1\t+\r1}"), 2);
}

TEST(Expression, knowsFrameAndT) {
  EXPECT_EQ(value_of("{frame}", {7, 0.25}), 7);
  EXPECT_EQ(value_of("{t}", {7, 0.25}), 0.25);
  EXPECT_EQ(value_of("{100*frame+t}", {7, 0.25}), 700.25);
}

TEST(Expression, isAtTheBeginningOfAnAnimationUnlessToldOtherwise) {
  EXPECT_EQ(value_of("{frame}"), 0);
  EXPECT_EQ(value_of("{t}"), 0);
}

TEST(Expression, knowsFunctions) {
  EXPECT_EQ(value_of("{sin(1)}"), std::sin(1.0));
  EXPECT_EQ(value_of("{cos(1)}"), std::cos(1.0));
  EXPECT_EQ(value_of("{tan(1)}"), std::tan(1.0));
  EXPECT_EQ(value_of("{asin(.5)}"), std::asin(0.5));
  EXPECT_EQ(value_of("{acos(.5)}"), std::acos(0.5));
  EXPECT_EQ(value_of("{atan(.5)}"), std::atan(0.5));
  EXPECT_EQ(value_of("{atan2(1, -2)}"), std::atan2(1.0, -2.0));
  EXPECT_EQ(value_of("{exp(1)}"), std::exp(1.0));
  EXPECT_EQ(value_of("{log(2)}"), std::log(2.0));
  EXPECT_EQ(value_of("{sqrt(2)}"), std::sqrt(2.0));
  EXPECT_EQ(value_of("{abs(-2)}"), 2);
  EXPECT_EQ(value_of("{floor(-1.5)}"), -2);
  EXPECT_EQ(value_of("{ceil(-1.5)}"), -1);
  EXPECT_EQ(value_of("{round(2.5)}"), 3);
  EXPECT_EQ(value_of("{sign(-3) + sign(0) + sign(.1)}"), 0);
  EXPECT_EQ(value_of("{min(3, 1, 2)}"), 1);
  EXPECT_EQ(value_of("{max(3, 1, 2)}"), 3);
  EXPECT_EQ(value_of("{pi}"), std::numbers::pi);
}

TEST(Expression, standsWhereverANumberDoes) {
  const ReadOptions options{.moment = {3, 0.5}};
  const Scene scene = scene_of("image_size {10*frame} {20 + frame}\nrays_per_pixel {frame+1}\n" + light +
                                   "sphere {t} {frame} 0 -4\nmoving_object 0 {2*t} 0 # {not read}\n",
                               options);
  EXPECT_EQ(scene.settings.width, 30);
  EXPECT_EQ(scene.settings.height, 23);
  EXPECT_EQ(scene.settings.rays_per_pixel, 4);
  EXPECT_EQ(scene.root.objects.at(0).motion.y, 1);
  const std::string corner = "begin\nvertex {t} 0 0\nvertex 1 {frame} 0\nvertex 0 1 {t - 1}\nend\n";
  EXPECT_EQ(corners(scene_of(light + corner, options), 0).at(2).z, -0.5);
}

TEST(Expression, makesASceneVary) {
  EXPECT_FALSE(read(light + ball).varies);
  EXPECT_TRUE(read(light + "sphere {1} 0 0 -4\n").varies);
}

TEST(Expression, isWrongAtItsPlace) {
  EXPECT_EQ(told("eye 1 {2 * fram} 3"),
            "s.cli:1:12: error: unknown name `fram` in this expression\n  eye 1 {2 * fram} 3\n             ^~~~\n  did "
            "you mean "
            "`frame`?\n");
  EXPECT_EQ(problem("{1 + $}"), "s.cli:1:10: error: `$` is not allowed in an expression");
  EXPECT_EQ(problem("{frame = 3}"), "s.cli:1:12: error: `=` is not allowed in an expression");
  EXPECT_EQ(problem("{\"a\"}"), "s.cli:1:6: error: `\"` is not allowed in an expression");
  EXPECT_EQ(problem("{1e}"), "s.cli:1:6: error: a number in this expression is incomplete");
  EXPECT_EQ(problem("{1e999}"), "s.cli:1:6: error: the number `1e999` is too large");
  EXPECT_EQ(problem("{}"), "s.cli:1:5: error: this expression is empty");
  EXPECT_EQ(problem("{  }"), "s.cli:1:6: error: this expression is empty");
  EXPECT_EQ(problem("{1 + }"), "s.cli:1:6: error: this expression ends too early");
  EXPECT_EQ(problem("{(1 + 2}"), "s.cli:1:6: error: a `)` is missing in this expression");
  EXPECT_EQ(problem("{1, 2}"), "s.cli:1:6: error: this expression has more than one value");
  EXPECT_EQ(problem("{1 2}"), "s.cli:1:8: error: `2` makes no sense at this place in the expression");
  EXPECT_EQ(problem("{1 * / 2}"), "s.cli:1:10: error: `/` makes no sense at this place in the expression");
  EXPECT_EQ(problem("{sin()}"), "s.cli:1:6: error: a function in this expression has too few arguments");
  EXPECT_EQ(problem("{sin(1, 2)}"), "s.cli:1:6: error: a function in this expression has too many arguments");
  EXPECT_EQ(problem("{1 ? 2}"), "s.cli:1:6: error: a `?` needs a `:` and another value in this expression");
  EXPECT_EQ(problem("{1}2"), "s.cli:1:8: error: `2` may not follow a `}` without a blank");
  EXPECT_EQ(problem("{" + std::string(1001, '1') + "}"),
            "s.cli:1:6: error: an expression may not have more than 1000 bytes");
}

TEST(Expression, hasToBeClosedInItsLine) {
  EXPECT_EQ(told("eye 1 {2 + 3 4\n"),
            "s.cli:1:7: error: this `{` has no `}` on the same line\n  eye 1 {2 + 3 4\n        ^\n");
  EXPECT_EQ(problem("{1 # }"), "s.cli:1:5: error: this `{` has no `}` on the same line");
}

TEST(Expression, hasToBeFinite) {
  EXPECT_EQ(told("eye {1 / t} 0 0"),
            "s.cli:1:5: error: `{1 / t}` is not finite when frame is 0 and t is 0\n  eye {1 / t} 0 0\n      "
            "^~~~~~~\n");
  EXPECT_EQ(problem("{sqrt(-1)}"), "s.cli:1:5: error: `{sqrt(-1)}` is not finite when frame is 0 and t is 0");
  EXPECT_EQ(problem("{10^39}"), "s.cli:1:5: error: `{10^39}` is not finite when frame is 0 and t is 0");
}

TEST(Expression, hasToBeInTheRangeOfItsArgument) {
  EXPECT_EQ(
      told("sphere {t - 0.5} 0 0 -4"),
      "s.cli:1:8: error: `radius` of `sphere` has to be greater than 0; found `{t - 0.5}`, which is -0.5\n  "
      "sphere {t - 0.5} 0 0 -4\n         ^~~~~~~~~\n  if this file has the order of 2018 (`sphere x y z radius`), "
      "--course=2018, or `course 2018` in the first line, reads that order\n");
  EXPECT_NE(told("rays_per_pixel {t + 0.5}").find("has to be a whole number"), std::string::npos);
}

TEST(Expression, isNoNameOfAFile) {
  const std::vector<Picture> list = pictures(read(light + ball + "write {a b}.png\n"));
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].file, "{a b}.png");
}

// Deep nesting, chains of operators and incomplete expressions: reading must end, with whatever answer.
TEST(Expression, ofAnySortIsRead) {
  for (const char* part : {"(", ")", "-", "1^", "sin(", "max(1,", "1?", "1?2:", "(1?", ",", ":", "&&", "t"}) {
    std::string text = "eye {";
    for (int i = 0; i < 300; i++) text += part;
    read(text + "} 0 0\n");
    read(text + "1} 0 0\n");
  }
}

}  // namespace
}  // namespace penumbra
