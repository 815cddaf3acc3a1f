// Surfaces that touch: lamps that lie in a surface, glass on a table, walls that meet in edges. Each scene must look
// like the same one with a gap of 1e-4, whatever the shapes are, wherever they stand and whichever comes first in the
// file.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/test_scale.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

const std::string turn = "rotate 37 1 2 3\n";

// Four corners as a polygon.
std::string quad(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  std::string text = "begin\n";
  for (const Vec3 p : {a, b, c, d}) text += fmt::format("vertex {} {} {}\n", p.x, p.y, p.z);
  return text + "end\n";
}

// A horizontal sheet.
std::string sheet(double y, double half) {
  return quad({-half, y, half}, {half, y, half}, {half, y, -half}, {-half, y, -half});
}

// The six walls of a box, seen from outside counter-clockwise.
std::string walls(Vec3 lo, Vec3 hi) {
  std::string text;
  for (int axis = 0; axis < 3; axis++) {
    for (const double at : {lo[axis], hi[axis]}) {
      Vec3 p[4];
      for (int k = 0; k < 4; k++) {
        p[k][axis] = at;
        p[k][(axis + 1) % 3] = k == 1 || k == 2 ? hi[(axis + 1) % 3] : lo[(axis + 1) % 3];
        p[k][(axis + 2) % 3] = k >= 2 ? hi[(axis + 2) % 3] : lo[(axis + 2) % 3];
      }
      text += at == hi[axis] ? quad(p[0], p[1], p[2], p[3]) : quad(p[0], p[3], p[2], p[1]);
    }
  }
  return text;
}

std::string look_at_room(int rays) {
  const int size = scaled(60, 16);
  return fmt::format("image_size {} {}\nfov 60\neye 0 1 4\nrays_per_pixel {}\n", size, size, rays);
}

std::string instance_of(const std::string& shapes, const std::string& matrix = "") {
  return "begin_list\n" + shapes + "end_list\nnamed_object it\npush\n" + matrix + "instance it\npop\n";
}

// How many pixels differ by more than a level of 255 would show, and by how much the means differ.
struct Difference {
  int pixels = 0;
  double mean = 0;
};
Difference difference(const Picture3& a, const Picture3& b) {
  Difference d;
  for (std::size_t i = 0; i < a.color.size(); i += 3) d.pixels += std::abs(a.color[i] - b.color[i]) > 0.01f;
  d.mean = std::abs(a.mean().x - b.mean().x);
  return d;
}

TEST(Touching, LampsThatLieInASurfaceLightFully) {
  const std::string ceilings[] = {
      "box -3 2 -3 3 2.1 3\n",  sheet(2, 3),          instance_of("box -3 2 -3 3 2.1 3\n"),
      instance_of(sheet(2, 3)), "sphere 50 0 52 0\n", "cylinder 3 0 0 2 2.5\n",
  };
  const std::string lamps[] = {"disk_light 0 {} 0 0.7 0 -1 0 1 1 1\n", "quad_light 0 {} 0 0.5 0 0.2 0 0 0.5 1 1 1\n",
                               "light 0 {} 0 1 1 1\n"};
  for (const std::string& ceiling : ceilings) {
    const bool round = ceiling.starts_with("sphere");
    for (const std::string& lamp : lamps) {
      if (round && !lamp.starts_with("light")) continue;  // a flat lamp does not lie in a round surface
      const auto scene = [&](double height) {
        std::string lines_of_lamp = fmt::format(fmt::runtime(lamp), height);
        return look_at_room(4) + lines_of_lamp + "diffuse .8 .8 .8 0 0 0\nbox -3 -0.1 -3 3 0 3\nsphere 0.5 0 0.5 0\n" +
               ceiling;
      };
      const Difference d = difference(render_text(scene(2)), render_text(scene(2 - 1e-4)));
      EXPECT_LE(d.pixels, 2) << ceiling << lamp;
      EXPECT_LT(d.mean, 2e-4) << ceiling << lamp;
    }
  }
}

// The floor shows through what stands on it, and light reaches it through that.
TEST(Touching, GlassShowsWhatItStandsOn) {
  const std::string glass = "translucent 0 0 0 0 0 0 1 0 0 0.9 1.5 0\n";
  const std::string table = "diffuse 0.9 0.2 0.2 0.1 0.1 0.1\n";
  struct Case {
    const char* name;
    std::string on, under;
    double gap_pixels;  // where edges of the gap show
  };
  const std::string lift = "push\ntranslate 0 1e-4 0\n";
  const Case cases[] = {
      {"box on a sheet", "box -1 0 -3 1 1 -1\n", sheet(0, 5), 0.02},
      {"box on a box", "box -1 0 -3 1 1 -1\n", "box -5 -1 -5 5 0 5\n", 0.02},
      {"walls on a sheet", walls({-1, 0, -3}, {1, 1, -1}), sheet(0, 5), 0.02},
      {"cylinder on a box", "cylinder 0.8 0 -2 0 1\n", "box -5 -1 -5 5 0 5\n", 0.02},
      {"instance on a sheet", instance_of("box -1 0 -3 1 1 -1\n"), sheet(0, 5), 0.02},
  };
  for (const Case& c : cases) {
    const auto scene = [&](bool gap, bool floor_first) {
      std::string on = glass + (gap ? lift : std::string("push\n")) + c.on + "pop\n";
      const std::string under = table + c.under;
      return "image_size 48 48\nfov 60\nbackground 0.3 0.5 0.9\nlight 0 5 0 1 1 1\neye 0 2 3\nmax_depth 12\n"
             "uvw 1 0 0 0 0.9 -0.436 0 0.436 0.9\n" +
             (floor_first ? under + on : on + under);
    };
    RenderSettings settings;
    settings.transparent_shadows = true;
    const Picture3 apart = render_text(scene(true, false), settings);
    const int allowed = static_cast<int>(c.gap_pixels * 48 * 48);
    for (const bool floor_first : {false, true}) {
      EXPECT_LE(difference(render_text(scene(false, floor_first), settings), apart).pixels, allowed)
          << c.name << (floor_first ? ", floor first" : "");
    }
  }
}

// A stack of random shapes, each lifted by the gap from the one below; glass never lies on glass. With a lamp in the
// ceiling.
std::string random_stack(std::uint32_t seed, double gap) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * 0x1p-64 * static_cast<double>(random()); };
  std::vector<std::string> shapes;
  const auto opaque = [&] { return fmt::format("diffuse {} {} {} 0.1 0.1 0.1\n", uniform(0, 1), uniform(0, 1), 0.5); };
  shapes.push_back(opaque() + (random() % 2 == 0 ? "box -9 -1 -9 9 0 9\n" : sheet(0, 9)));
  double y = 0;
  bool on_glass = false;
  for (int layer = 1; layer < 4; layer++) {
    const bool glass = !on_glass && random() % 2 == 0;
    const std::string surface = glass ? "translucent 0.1 0 0 0 0 0 1 0.2 0 0.7 1.4 0\n" : opaque();
    const double height = uniform(0.2, 0.6), half = uniform(0.4, 1.2);
    const double low = y + layer * gap, high = low + height;
    const Vec3 lo{-half, low, -2 - half}, hi{half, high, -2 + half};
    const std::string corners = fmt::format("{} {} {} {} {} {}\n", lo.x, lo.y, lo.z, hi.x, hi.y, hi.z);
    switch (random() % 4) {
      case 0:
        shapes.push_back(surface + "box " + corners);
        break;
      case 1:
        shapes.push_back(surface + walls(lo, hi));
        break;
      case 2:
        shapes.push_back(surface + fmt::format("cylinder {} 0 -2 {} {}\n", half, low, high));
        break;
      default:
        shapes.push_back(surface + instance_of("box " + corners));
    }
    y += height;
    on_glass = glass;
  }
  shapes.push_back(opaque() + "box -9 3 -9 9 3.5 9\n");
  std::shuffle(shapes.begin(), shapes.end(), random);
  std::string text = fmt::format(
      "image_size 40 40\nfov 60\neye 0.3 1.7 3\nuvw 1 0 0 0 0.95 -0.312 0 0.312 0.95\nmax_depth 8\n"
      "background 0.3 0.5 0.9\nrays_per_pixel 4\nlight 2 {0} 1 0.6 0.6 0.6\ndisk_light -2 {0} 0 0.5 0 1 0 0.4 0.4 "
      "0.4\n",
      3 - gap);
  for (std::size_t i = 0; i < shapes.size(); i++) {
    std::string shape = shapes[i];
    for (const std::string word : {"named_object it", "instance it"}) {
      if (const std::size_t at = shape.find(word); at != std::string::npos) {
        shape.insert(at + word.size(), std::to_string(i));
      }
    }
    text += shape;
  }
  return text;
}

TEST(Touching, RandomStacksLookAsWithGaps) {
  for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(scaled(200, 6)); seed++) {
    for (const bool transparent : {false, true}) {
      RenderSettings settings;
      settings.transparent_shadows = transparent;
      const Picture3 touching = render_text(random_stack(seed, 0), settings);
      const Picture3 apart = render_text(random_stack(seed, 1e-4), settings);
      EXPECT_LE(difference(touching, apart).pixels, 8) << "seed " << seed << (transparent ? ", transparent" : "");
    }
  }
}

// Nothing reflects totally between two blocks of glass that touch.
TEST(Touching, BlocksOfGlassAreOneBlock) {
  const std::string head =
      "image_size 60 60\nfov 60\nbackground 0.3 0.5 0.9\nlight 0 5 0 1 1 1\neye 0.5 2 3\nmax_depth 14\n"
      "uvw 1 0 0 0 0.9 -0.436 0 0.436 0.9\ntranslucent 0 0 0 0 0 0 1 0 0 1 1.5 0\n";
  const std::string table = "diffuse 0.9 0.2 0.2 0.1 0.1 0.1\nbox -5 -0.5 -5 5 -0.2 5\nsphere .3 .2 .1 -3.5\n";
  const Picture3 one = render_text(head + "box -1 0 -3 1 1 -1\n" + table);
  for (const std::string two :
       {"box -1 0 -3 1 .5 -1\nbox -1 .5 -3 1 1 -1\n", "box 0 0 -3 1 1 -1\nbox -1 0 -3 0 1 -1\n"}) {
    EXPECT_LE(difference(render_text(head + two + table), one).pixels, 20) << two;
  }
  const std::string walls_of_both = walls({-1, 0, -3}, {1, 0.5, -1}) + walls({-1, 0.5, -3}, {1, 1, -1});
  EXPECT_LE(difference(render_text(head + walls_of_both + table), one).pixels, 20);
}

// A point of a surface whose light comes from behind sees it through that surface, like through any other.
TEST(Touching, LightFromBehindCrossesTheSurfaceItself) {
  struct Case {
    const char* name;
    std::string scene;
    double brightest;
  };
  const std::string head = "image_size 31 31\nfov 40\nmax_depth 0\nlight 0 0 -10 1 1 1\n";
  const std::string glass = "shiny 1 1 1 0 0 0 0 0 0 1 0 0.5 1\n";
  const Case cases[] = {
      {"from inside a ball", head + glass + "sphere 5 0 0 0\n", 0.5},
      {"from inside a turned ball", head + glass + turn + "scale 1 1 1.0001\nsphere 5 0 0 0\n", 0.5},
      {"highlight through a ball", head + "highlight phong\nshiny 0 0 0 0 0 0 1 1 1 0 0 0.5 1\nsphere 1 0 0 -4\n",
       0.25},
      {"opaque tube",
       "image_size 31 31\nfov 50\nlight 30 20 10 1 1 1\ndiffuse 1 1 1 0.05 0.05 0.05\npush\ntranslate 0 0 -4\n"
       "rotatex 75\nhollow_cylinder 1 0 0 -1.5 1.5\npop\n",
       0.05},
  };
  RenderSettings settings;
  settings.transparent_shadows = true;
  for (const Case& c : cases) {
    const Picture3 picture = render_text(c.scene, settings);
    EXPECT_NEAR(*std::ranges::max_element(picture.color), c.brightest, 1e-4) << c.name;
  }
}

// In a closed room whose walls shine by `shine` and reflect `k`, a pixel is shine (1 + k + k^2 + ...), as deep as rays
// go: what leaves through an edge brings the background instead. Glossy walls do not shine.
TEST(Touching, ClosedRoomsLeakNothing) {
  struct Room {
    const char* name;
    std::string shapes;
  };
  const std::string cell = walls({-2, -1, -3}, {2, 3, 1});
  const Room rooms[] = {
      {"walls", cell},
      {"turned walls", "push\n" + turn + cell + "pop\n"},
      {"instance of walls", instance_of(cell, turn)},
      {"scaled instance", instance_of(cell, turn + "scale 1 0.7 1.3\n")},
      {"box", "box -2 -1 -3 2 3 1\n"},
      {"turned box", instance_of("box -2 -1 -3 2 3 1\n", turn)},
      {"sphere", "sphere 3 0 0.5 -1\n"},
      {"ellipsoid", "push\n" + turn + "scale 1 0.6 1\nsphere 3 0 0 0\npop\n"},
      {"cylinder", "cylinder 2 0 0 -1 2\n"},
      {"turned cone", "push\n" + turn + "cone 0 -1 0 4 0.8\npop\n"},
  };
  const int depth = 30;
  for (const Room& room : rooms) {
    for (const double k : {0.5, 1.0}) {
      for (const bool glossy : {false, true}) {
        const double shine = glossy ? 0 : 0.25;
        const std::string surface = glossy ? fmt::format("glossy 0 0 0 0 0 0 1 {} 0.3\n", k)
                                           : fmt::format("shiny 0 0 0 {0} {0} {0} 0 0 0 1 {1} 0 1\n", shine, k);
        const int size = scaled(64, 12);
        const Picture3 picture = render_text(
            fmt::format("image_size {0} {0}\nfov 100\nrays_per_pixel 16\nmax_depth {1}\nbackground 1000 1000 1000\n",
                        size, depth) +
            surface + room.shapes);
        double expected = 0;
        for (int n = 0; n <= depth; n++) expected += shine * std::pow(k, n);
        int leaks = 0;
        for (const float v : picture.color) leaks += !(std::abs(v - expected) < 1e-5);
        EXPECT_EQ(leaks, 0) << room.name << ", k = " << k << (glossy ? ", glossy" : "") << ", of "
                            << picture.color.size();
      }
    }
  }
}

// The size of the ground does not matter to what stands on it.
TEST(Touching, LargeGroundsHaveContactShadows) {
  const auto scene = [](double size, const std::string& ground) {
    return "image_size 40 20\nfov 40\nrays_per_pixel 4\neye 0 1 0\nlight 2 5 1 .9 .9 .9\ndiffuse .8 .2 .2 .1 .1 .1\n"
           "sphere 1 0 0 -5\ndiffuse .7 .7 .6 .1 .1 .1\n" +
           fmt::format(fmt::runtime(ground), size);
  };
  const std::string box = "box -{0} -{0} -{0} {0} -1 {0}\n";
  const Picture3 small = render_text(scene(1e3, box));
  for (const std::string& ground :
       {box,
        std::string("begin\nvertex -{0} -1 {0}\nvertex {0} -1 {0}\nvertex {0} -1 -{0}\nvertex -{0} -1 -{0}\nend\n"),
        std::string("cylinder {0} 0 0 -2 -1\n"), std::string("sphere {0} 0 {{-{0} - 1}} 0\n")}) {
    for (const double size : {1e5, 1e6}) {
      EXPECT_LE(difference(render_text(scene(size, ground)), small).pixels, 40) << size << " " << ground;
    }
  }
}

}  // namespace
}  // namespace penumbra::test
