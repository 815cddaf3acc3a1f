// The years of the course: `course`, `highlight`, the orders of 2018, and what hints at them.
#include "scene/course.hpp"

#include "support.hpp"

namespace penumbra {
namespace {

const std::string shiny_surface = "surface .1 .2 .3 .4 .5 .6 .7 .8 .9 20 .25\n";
const std::string red_ball = "sphere 1 0 0 -4\n";
const std::string white_light = "light 5 5 5 1 1 1\n";

const Surface& only_surface(const Scene& scene) { return scene.surfaces.at(scene.root.objects.at(0).surface); }

TEST(Course, IsSaidByTheSceneOrByTheOption) {
  const std::string rest = white_light + red_ball;
  EXPECT_EQ(scene_of(rest).settings.course, Course::off);
  EXPECT_EQ(scene_of("course\n" + rest).settings.course, Course::any_year);
  EXPECT_EQ(scene_of("# first\ncourse 2017\n" + rest).settings.course, Course::year_2017);
  EXPECT_EQ(scene_of("course 2017\n" + rest, {.course = Course::year_2015}).settings.course, Course::year_2015)
      << "the command line wins";
  EXPECT_EQ(scene_of("course\n" + rest).settings.pattern, Pattern::random);
  EXPECT_EQ(scene_of("course\nsampler sobol\n" + rest).settings.pattern, Pattern::sobol);
}

TEST(Course, HasAYearThatThereIsAndComesFirst) {
  EXPECT_EQ(told("course 2016\n"),
            "s.cli:1:8: error: there is no course of `2016`; the years are 2015, 2017, 2018, 2022\n  course 2016\n"
            "         ^~~~\n");
  EXPECT_EQ(told(white_light + "course 2017\n"),
            "s.cli:2:1: error: `course` has to come before every other command\n  course 2017\n  ^~~~~~\n");
}

TEST(Course, YearsHaveTheirOwnDepthUnlessTheSceneSaysOne) {
  const std::vector<std::pair<std::string, int>> depths = {
      {"course", 8}, {"course 2015", 5}, {"course 2017", 20}, {"course 2018", 9}, {"course 2022", 8}};
  for (const auto& [line, depth] : depths) {
    const bool of_2018 = line.ends_with("2018");
    const std::string rest = of_2018 ? "light 1 1 1 5 5 5\nsphere 0 0 -4 1\n" : white_light + red_ball;
    EXPECT_EQ(scene_of(line + "\n" + rest).settings.max_depth, depth) << line;
    EXPECT_EQ(scene_of(line + "\nmax_depth 3\n" + rest).settings.max_depth, 3) << line;
  }
}

TEST(Course, TheHighlightOfSurfaceAndShinyIsOpen) {
  const auto highlight_after = [](const std::string& text, Course course = Course::off) {
    return only_surface(scene_of(white_light + text + red_ball, {.course = course})).highlight;
  };
  const std::string shiny = "shiny 1 1 1 0 0 0 1 1 1 20 0 0 1\n";
  for (const std::string& surface : {shiny_surface, shiny}) {
    EXPECT_EQ(highlight_after(surface), Highlight::blinn);
    EXPECT_EQ(highlight_after("highlight phong\n" + surface), Highlight::phong);
    EXPECT_EQ(highlight_after(surface + "highlight phong\n"), Highlight::blinn) << "it is for surfaces that follow";
    EXPECT_EQ(highlight_after(surface, Course::year_2015), Highlight::phong);
    EXPECT_EQ(highlight_after("highlight blinn\n" + surface, Course::year_2015), Highlight::blinn);
    EXPECT_EQ(highlight_after(surface, Course::year_2017), Highlight::blinn);
  }
  EXPECT_EQ(highlight_after("highlight phong\nglossy 1 1 1 1 1 1 20 0 0\n"), Highlight::blinn);
  EXPECT_NE(told("highlight gouraud\n").find("there is no highlight `gouraud`; there are blinn, phong"),
            std::string::npos);
}

TEST(Course, Of2018HasItsOwnOrders) {
  const Scene scene = scene_of("light .1 .2 .3 4 5 6\nsurface .1 .2 .3 .4 .5 .6 .7 .8 .9 20 .25\nsphere 1 2 -3 4\n",
                               {.course = Course::year_2018});
  const auto& light = std::get<PointLight>(scene.lights.at(0));
  EXPECT_EQ(light.color, (Vec3{.1, .2, .3}));
  EXPECT_EQ(light.position, (Vec3{4, 5, 6}));
  const Surface& surface = only_surface(scene);
  EXPECT_EQ(surface.ambient, (Vec3{.1, .2, .3}));
  EXPECT_EQ(surface.diffuse, (Vec3{.4, .5, .6}));
  EXPECT_EQ(surface.specular, (Vec3{.7, .8, .9}));
  EXPECT_EQ(surface.specular_power, 20);
  EXPECT_EQ(surface.reflection, .25);
  const auto& sphere = shape_of<Sphere>(scene.root.objects.at(0));
  EXPECT_EQ(sphere.center, (Vec3{1, 2, -3}));
  EXPECT_EQ(sphere.radius, 4);
}

TEST(Course, ARadiusThatIsNotPositiveHintsAt2018) {
  EXPECT_NE(told(white_light + "sphere 0 0 -4 1\n").find("--course=2018"), std::string::npos);
  EXPECT_EQ(told("course 2018\nlight 1 1 1 5 5 5\nsphere 0 0 -4 -1\n").find("--course=2018"), std::string::npos);
}

TEST(Course, SeveralSignsOf2018AreAWarning) {
  const std::string bright = "light .5 .5 .5 40 0 0\n", ambient_first = "surface 0 0 0 .7 .7 .7 0 0 0 20 .7\n";
  const std::string behind = "sphere 1 1 -1 1.4\n";
  EXPECT_NE(told(bright + ambient_first + behind).find("warning: lights, surfaces and spheres look as if"),
            std::string::npos);
  EXPECT_NE(told("light .5 .5 .5 .4 0 0\n" + behind).find("--course=2018"), std::string::npos);
  EXPECT_EQ(told(white_light + ambient_first + red_ball), "") << "one sign is not enough";
  EXPECT_EQ(told("course 2018\n" + bright + ambient_first + behind), "");
}

TEST(Course, AWordBehindBeginIsIgnored) {
  const std::string corners = "vertex 0 0 -5\nvertex 1 0 -5\nvertex 0 1 -5\nend\n";
  EXPECT_EQ(told(white_light + "begin triangle\n" + corners), "");
  const std::string wrong = told(white_light + "begin a b\n" + corners);
  EXPECT_EQ(wrong.find("error"), wrong.rfind("error")) << "one fault is one error: " << wrong;
}

TEST(Course, AnIndexOfZeroIsFineWhereNothingIsRefracted) {
  EXPECT_EQ(told(white_light + "shiny .2 .2 .2 0 0 0 0 0 0 1 .5 0 0\n" + red_ball), "");
  EXPECT_NE(told(white_light + "shiny .2 .2 .2 0 0 0 0 0 0 1 .5 .1 0\n" + red_ball).find("`index` of `shiny`"),
            std::string::npos);
  EXPECT_NE(told(white_light + "translucent 1 1 1 0 0 0 1 0 0 .1 0 0\n" + red_ball).find("`index` of `translucent`"),
            std::string::npos);
}

}  // namespace
}  // namespace penumbra
