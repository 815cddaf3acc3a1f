// Slips of people who know other languages: one clear message, with its place.
#include <fmt/format.h>

#include "support.hpp"

namespace penumbra {
namespace {

// A message at a place of a line, and the line with its mark.
std::string at(int line, int column, const std::string& message, const std::string& text, int width = 1) {
  return fmt::format("s.cli:{}:{}: {}\n  {}\n  {}^{}\n", line, column, message, text, std::string(column - 1, ' '),
                     std::string(width - 1, '~'));
}

TEST(Slip, CommentsOfOtherLanguages) {
  const std::string error = "error: `//` does not begin a comment; `#` does";
  EXPECT_EQ(told("// a ball and its light\n" + light + ball), at(1, 1, error, "// a ball and its light", 2));
  EXPECT_EQ(told("//a ball\n" + light + ball), at(1, 1, error, "//a ball", 2));
  EXPECT_EQ(told(light + "sphere 1 0 0 -4 // a ball\n"), at(2, 17, error, "sphere 1 0 0 -4 // a ball", 2));
  EXPECT_EQ(told(light + ball + "write a.png // done\n"), at(3, 13, error, "write a.png // done", 2));
  EXPECT_EQ(told(light + ball + "render //done\n"), at(3, 8, error, "render //done", 2));
  EXPECT_EQ(told("/* a ball */\n" + light + ball),
            at(1, 1, "error: `/*` does not begin a comment; `#` does", "/* a ball */", 2));
  EXPECT_EQ(told("course // the old one\n" + light + ball), at(1, 8, error, "course // the old one", 2));
  // The rest of a polygon is not to blame.
  EXPECT_EQ(told(light + "begin // a\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nend\n"),
            at(2, 7, error, "begin // a", 2));
  EXPECT_EQ(told(light + "begin\nvertex 0 0 0 // a\nvertex 1 0 0\nvertex 0 1 0\nend\n"),
            at(3, 14, error, "vertex 0 0 0 // a", 2));
  EXPECT_EQ(told(light + "read parts//ball.cli # // fine\n", {}, {{"parts//ball.cli", ball}}), "");
}

TEST(Slip, Commas) {
  const std::string error = "error: numbers are separated by blanks, without commas";
  EXPECT_EQ(told(light + "sphere 1, 0, 0, -4\n"), at(2, 9, error, "sphere 1, 0, 0, -4"));
  EXPECT_EQ(told(light + "sphere 1,0,0,-4\n"), at(2, 9, error, "sphere 1,0,0,-4"));
  EXPECT_EQ(told(light + "sphere 1 , 0 , 0 , -4\n"), at(2, 10, error, "sphere 1 , 0 , 0 , -4"));
  EXPECT_EQ(told(light + "begin\nvertex 0, 0, 0\nvertex 1 0 0\nvertex 0 1 0\nend\n"),
            at(3, 9, error, "vertex 0, 0, 0"));
  EXPECT_EQ(told(light + "rotate 90, 0, 1, 0\n" + ball), at(2, 10, error, "rotate 90, 0, 1, 0"));
  EXPECT_EQ(told(light + "sphere {max(1, 0.5)} 0 0 -4 # a, b\n"), "");
  EXPECT_EQ(told(light + "read a,b.cli\nwrite a,b.png\n", {}, {{"a,b.cli", ball}}), "");
}

TEST(Slip, ColoursOf255) {
  const std::string warning = "warning: this colour looks like one from 0 to 255; colours run from 0 to 1";
  const auto meant = [](const std::string& color) { return "  did you mean `" + color + "`?\n"; };
  EXPECT_EQ(told(light + "diffuse 255 128 0 0.1 0.1 0\n" + ball),
            at(2, 9, warning, "diffuse 255 128 0 0.1 0.1 0", 9) + meant("1 0.502 0"));
  EXPECT_EQ(told(light + "diffuse 1 0 0  20 0 0\n" + ball),
            at(2, 16, warning, "diffuse 1 0 0  20 0 0", 6) + meant("0.0784 0 0"));
  EXPECT_EQ(told("background 30 60 90\n" + light + ball),
            at(1, 12, warning, "background 30 60 90", 8) + meant("0.118 0.235 0.353"));
  EXPECT_EQ(told("light 0 9 0 255 255 255\n" + ball),
            at(1, 13, warning, "light 0 9 0 255 255 255", 11) + meant("1 1 1"));
  EXPECT_EQ(told("rays_per_pixel 4\ndisk_light 0 9 0 1 0 -1 0 200 200 100\n" + ball),
            at(2, 27, warning, "disk_light 0 9 0 1 0 -1 0 200 200 100", 11) + meant("0.784 0.784 0.392"));
  EXPECT_EQ(told("color 0 255 0\nrect 0 0 5 5\n"), at(1, 7, warning, "color 0 255 0", 7) + meant("0 1 0"));
  for (const std::string fine : {"light 0 9 0 4 4 4\n", "light 0 9 0 20.5 20.5 20.5\n", "light 100 200 100 1 1 1\n",
                                 "light 0 9 0 1000 1000 1000\n"}) {
    EXPECT_EQ(told(fine + ball), "");
  }
  EXPECT_EQ(told(light + "diffuse 1 1 1 1 1 1\nglossy 0.5 1.5 0 1 1 1 64 1 0.1\n" + ball), "");
}

TEST(Slip, NamesOfPictures) {
  const std::string error = "error: the name of a picture has to end in .png or .exr; found ";
  for (const std::string name : {"out.jpg", "out", "out.png.gz", ".png", "png"}) {
    const std::string line = "write " + name;
    EXPECT_EQ(told(light + ball + line + "\n"),
              at(3, 7, error + "`" + name + "`", line, static_cast<int>(name.size())));
    EXPECT_NE(told(light + ball + line + "\n", {.lenient = true}).find("warning: the name"), std::string::npos);
  }
  EXPECT_EQ(told(light + ball + "write out.PNG\nwrite a.b.exr\nwrite out.%04d.png\n"), "");
}

}  // namespace
}  // namespace penumbra
