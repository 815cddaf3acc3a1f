// Solid textures: the geometry of rings and stones against twins written out plainly, the statistics that the published
// pictures show, the space in which a texture is fixed, and that no lane sees its neighbours.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "base/hash.hpp"
#include "base/test_scale.hpp"
#include "tracing/one_ray.hpp"

namespace penumbra::test {
namespace {

constexpr LaneFunction wood_channels[] = {LaneFunction::wood_red, LaneFunction::wood_green, LaneFunction::wood_blue};
constexpr LaneFunction stone_channels[] = {LaneFunction::stone_red, LaneFunction::stone_green,
                                           LaneFunction::stone_blue};

struct Points {
  std::vector<float> x, y, z;

  void add(double px, double py, double pz) {
    x.push_back(static_cast<float>(px));
    y.push_back(static_cast<float>(py));
    z.push_back(static_cast<float>(pz));
  }
  std::size_t size() const { return x.size(); }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

std::vector<float> values(LaneFunction function, const Points& p, const Kernel& kernel = *usable_kernels().back()) {
  std::vector<float> out(p.size());
  kernel.evaluate(function, p.x, p.y, p.z, out);
  return out;
}

// Independent points of a cube: from one to the next the textures have nothing in common.
Points random_points(int count, double half_side, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-half_side, half_side);
  Points points;
  for (int i = 0; i < count; i++) {
    const double x = place(random), y = place(random);
    points.add(x, y, place(random));
  }
  return points;
}

struct Moments {
  double mean, deviation;
};

Moments moments(const std::vector<float>& list) {
  double sum = 0, squares = 0;
  for (const float v : list) sum += v;
  const double mean = sum / static_cast<double>(list.size());
  for (const float v : list) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / static_cast<double>(list.size()))};
}

// Five standard deviations of a share: one right texture in a million fails.
double share_tolerance(double share, std::size_t count) {
  return 5 * std::sqrt(share * (1 - share) / static_cast<double>(count));
}

constexpr float early_red = 0.45f;  // between early and late wood

// Outwards from the x axis, at any x and in any direction, ring k begins at r = k / 10, give or take the warp of 0.03
// times noise (at most 1.1 by size) and the ring's phase of 0.035; there is no other edge but that of its late wood.
TEST(Texture, WoodHasTenRingsToAUnitRoundTheXAxis) {
  constexpr int lines = scaled(400, 40), steps = 4000;
  constexpr double step = 0.001, warp = 0.033 + step;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-20, 20), turn(0, 2 * std::numbers::pi);
  int light = 0, total = 0;
  for (int line = 0; line < lines; line++) {
    const double x = place(random), angle = turn(random);
    Points points;
    for (int i = 0; i < steps; i++) points.add(x, i * step * std::cos(angle), i * step * std::sin(angle));
    const std::vector<float> red = values(LaneFunction::wood_red, points);
    int ring = 0;
    for (std::size_t i = 1; i < steps; i++) {
      const double r = static_cast<double>(i) * step;
      light += red[i] > early_red;
      total++;
      if (red[i - 1] < early_red && red[i] > early_red) {
        ring++;
        // The phase is below zero where the warp is: then the first edge is that of ring 0.
        if (ring == 1 && r < 0.05) ring = 0;
        ASSERT_NEAR(r, (ring - 0.035) / 10, warp) << "ring " << ring << ", x " << x << ", angle " << angle;
      }
    }
    EXPECT_NEAR(ring, 40, 1);
  }
  // Neighbouring points of a line are not independent, its 40 rings are about so.
  EXPECT_NEAR(light / static_cast<double>(total), 0.6, share_tolerance(0.6, std::size_t{40} * lines));
}

TEST(Texture, WoodIsOfTwoColoursWithGrain) {
  const Points points = random_points(scaled(100000, 5000), 100);
  std::vector<float> channel[3];
  for (int c = 0; c < 3; c++) channel[c] = values(wood_channels[c], points);
  std::vector<float> grain;
  for (std::size_t i = 0; i < points.size(); i++) {
    const bool light = channel[0][i] > early_red;
    const float base[3] = {light ? 0.70f : 0.20f, light ? 0.30f : 0.05f, light ? 0.15f : 0.02f};
    grain.push_back(channel[0][i] - base[0]);
    EXPECT_LE(std::abs(grain.back()), 0.055f);
    for (int c = 1; c < 3; c++) EXPECT_NEAR(channel[c][i], std::max(base[c] + grain.back(), 0.0f), 1e-6);
  }
  const Moments m = moments(grain);
  EXPECT_NEAR(m.mean, 0, 5 * m.deviation / std::sqrt(static_cast<double>(grain.size())));
  EXPECT_NEAR(m.deviation, 0.0133, 0.002);  // as in the published picture
}

// Published: grey from 0 to 0.70 with a median of 0.38 and, over the whole ball, a mean of 0.38 and a deviation of
// 0.18.
TEST(Texture, MarbleHasThePublishedGreys) {
  std::vector<float> grey = values(LaneFunction::marble, random_points(scaled(100000, 10000), 100));
  std::sort(grey.begin(), grey.end());
  EXPECT_GE(grey.front(), -1e-6f);
  EXPECT_LT(grey.front(), 0.01f);
  EXPECT_LE(grey.back(), 0.711f);
  EXPECT_GT(grey.back(), 0.70f);
  EXPECT_NEAR(grey[grey.size() / 2], 0.38, 0.03);
  const Moments m = moments(grey);
  EXPECT_NEAR(m.mean, 0.38, 0.03);
  EXPECT_NEAR(m.deviation, 0.18, 0.02);
}

// Creases are sharp, but nowhere does the grey jump: the slope stays below that of the steepest layer times that of the
// turbulence, about 0.7 * 40 * 30.
TEST(Texture, MarbleIsContinuous) {
  Points line;
  constexpr double step = 1e-5;
  for (int i = 0; i < scaled(400000, 20000); i++) line.add(1.3 + i * step, 0.7 - 0.5 * i * step, -2.2 + 0.3 * i * step);
  const std::vector<float> grey = values(LaneFunction::marble, line);
  double jump = 0;
  for (std::size_t i = 1; i < grey.size(); i++) jump = std::max(jump, double{std::abs(grey[i] - grey[i - 1])});
  EXPECT_LT(jump, 850 * step);
  EXPECT_GT(jump, 10 * step);
}

constexpr double cubes_per_unit = 3.1, half_width = 0.0115;

// In units.
std::vector<float> stone_borders(const Points& points) {
  std::vector<float> list = values(LaneFunction::stone_border, points);
  for (float& v : list) v /= static_cast<float>(cubes_per_unit);
  return list;
}

struct Feature {
  Vec3 way;  // from the place to the feature point, in cubes
  std::uint32_t bits;
  int cubes_away;  // of its cube, in the largest coordinate
};

// Calls visit with the feature point of every cube up to `reach` cubes away.
template <typename Visit>
void for_features(Vec3 place, int reach, Visit visit) {
  const auto mix = [](std::uint32_t before, int cube) {
    return mix_bits(static_cast<std::uint32_t>(cube) * 0x9e3779b9u + before);
  };
  const auto cube_of = [](double x) { return static_cast<int>(std::floor(x)); };
  const int x = cube_of(place.x), y = cube_of(place.y), z = cube_of(place.z);
  for (int i = -reach; i <= reach; i++) {
    for (int j = -reach; j <= reach; j++) {
      for (int k = -reach; k <= reach; k++) {
        const std::uint32_t bits = mix(mix(mix(0, x + i), y + j), z + k);
        const auto part = [bits](int shift) { return ((bits >> shift & 1023) + 0.5) / 1024; };
        const Vec3 point{x + i + part(0), y + j + part(10), z + k + part(20)};
        visit(Feature{point - place, bits, std::max({std::abs(i), std::abs(j), std::abs(k)})});
      }
    }
  }
}

struct TwinCell {
  double border = 1e9;  // in units
  Vec3 tint;
  int cubes_away = 0;  // of the own feature point
};

// The stone round a place from all feature points of 7 x 7 x 7 cubes, in double precision.
TwinCell twin_cell(Vec3 p) {
  // The packets scale the point in single precision.
  const auto to_cubes = [](double x) { return double{static_cast<float>(x) * 3.1f}; };
  std::vector<Feature> features;
  for_features({to_cubes(p.x), to_cubes(p.y), to_cubes(p.z)}, 3, [&](const Feature& f) { features.push_back(f); });
  const auto nearer = [](const Feature& a, const Feature& b) { return dot(a.way, a.way) < dot(b.way, b.way); };
  std::iter_swap(features.begin(), std::min_element(features.begin(), features.end(), nearer));
  const Feature& own = features[0];
  TwinCell cell;
  for (std::size_t i = 1; i < features.size(); i++) {
    const Vec3 middle = (features[i].way + own.way) / 2;
    cell.border = std::min(cell.border, dot(middle, normalize(features[i].way - own.way)) / cubes_per_unit);
  }
  cell.cubes_away = own.cubes_away;
  const std::uint32_t bits = mix_bits(own.bits);
  const auto share = [bits](int shift) { return (bits >> shift & 1023) / 1023.0; };
  cell.tint = {share(20) < 0.04  ? 0.61
               : share(20) < 0.1 ? 0.76
                                 : 0.82,
               0.30 + 0.10 * share(0), 0.06 + 0.21 * share(10)};
  return cell;
}

// How much nearer a place is to a feature point two cubes away than to any in the cubes between.
double loneliness(Vec3 cubes) {
  double inner = 1e9, outer = 1e9;
  for_features(cubes, 2, [&](const Feature& f) {
    double& square = f.cubes_away == 2 ? outer : inner;
    square = std::min(square, dot(f.way, f.way));
  });
  return std::sqrt(inner) - std::sqrt(outer);
}

// Places that belong to a point two cubes away are one in a million: they are found by climbing.
void add_lonely_places(Points& points) {
  std::mt19937 random(6);
  std::normal_distribution<double> step(0, 0.06);
  std::uniform_real_distribution<double> anywhere(-60, 60);
  for (int start = 0; start < scaled(3000, 0); start++) {
    const double x = anywhere(random), y = anywhere(random);
    Vec3 place{x, y, anywhere(random)};
    double highest = loneliness(place);
    for (int k = 0; k < 60; k++) {
      const double dx = step(random), dy = step(random);
      const Vec3 next = place + Vec3{dx, dy, step(random)};
      const double height = loneliness(next);
      if (height <= highest) continue;
      highest = height;
      place = next;
      if (height > 0) points.add(place.x / cubes_per_unit, place.y / cubes_per_unit, place.z / cubes_per_unit);
    }
  }
}

TEST(Texture, StoneAgreesWithAWiderSearch) {
  Points points = random_points(scaled(20000, 1000), 20);
  add_lonely_places(points);
  // Near corners, edges and faces of the cubes, on both sides of zero.
  std::mt19937 random(3);
  std::uniform_int_distribution<int> whole(-30, 30), grid(-4, 4);
  for (int i = 0; i < scaled(4000, 400); i++) {
    const auto place = [&] { return (whole(random) + grid(random) * 1e-4) / cubes_per_unit; };
    const double x = place(), y = place();
    points.add(x, y, place());
  }
  const std::vector<float> border = stone_borders(points);
  std::vector<float> channel[3];
  for (int c = 0; c < 3; c++) channel[c] = values(stone_channels[c], points);
  int two_cubes_away = 0, mortar = 0;
  for (std::size_t i = 0; i < points.size(); i++) {
    const TwinCell twin = twin_cell(points.at(i));
    ASSERT_NEAR(border[i], std::min(twin.border, half_width), 2e-6) << "point " << i;
    two_cubes_away += twin.cubes_away == 2;
    EXPECT_LT(twin.cubes_away, 3);
    if (std::abs(twin.border - half_width) < 2e-6) continue;
    // The noise is the same in all channels, and smaller than from mortar to stone.
    const double red_green = channel[0][i] - channel[1][i], green_blue = channel[1][i] - channel[2][i];
    const bool stone = twin.border > half_width;
    EXPECT_NEAR(red_green, stone ? twin.tint.x - twin.tint.y : 0, 1e-6);
    EXPECT_NEAR(green_blue, stone ? twin.tint.y - twin.tint.z : 0, 1e-6);
    EXPECT_NEAR(channel[1][i], stone ? twin.tint.y : 0.6, stone ? 0.055 : 0.11);
    mortar += !stone;
  }
  if (!slow_build) {
    EXPECT_GT(two_cubes_away, 0) << "the hard case is not among the points";
  }
  EXPECT_GT(mortar, 0);
}

// Across the mortar the distance to the border grows as distance does: 1 for 1. So the mortar is a slab of even width,
// but for the corners where borders meet. (The difference of the two distances grows by anything from 0 to 2.)
TEST(Texture, MortarIsOfEvenWidth) {
  const Points candidates = random_points(scaled(60000, 6000), 20);
  const std::vector<float> border = stone_borders(candidates);
  constexpr double h = 1.0 / 1024;
  Points around;
  for (std::size_t i = 0; i < candidates.size(); i++) {
    if (border[i] < 2 * h || border[i] > half_width - 2 * h) continue;
    const Vec3 p = candidates.at(i);
    for (const double s : {-h, h}) around.add(p.x + s, p.y, p.z);
    for (const double s : {-h, h}) around.add(p.x, p.y + s, p.z);
    for (const double s : {-h, h}) around.add(p.x, p.y, p.z + s);
  }
  const std::vector<float> near = stone_borders(around);
  int even = 0, corners = 0;
  for (std::size_t i = 0; i < near.size(); i += 6) {
    const Vec3 slope = Vec3{near[i + 1] - near[i], near[i + 3] - near[i + 2], near[i + 5] - near[i + 4]} / (2 * h);
    EXPECT_LT(max_component(abs(slope)), 1.001);
    (std::abs(length(slope) - 1) < 0.01 ? even : corners)++;
  }
  EXPECT_GT(even, 100);
  EXPECT_GT(even, 9 * corners);
}

// Published: 19 % of the area of a ball is mortar, of grey 0.60 with a deviation of 0.03; most stones have a red of
// 0.82, few of 0.61. The share of a surface is that of space.
TEST(Texture, StoneHasThePublishedColours) {
  const Points points = random_points(scaled(100000, 10000), 100);
  std::vector<float> channel[3], mortar, red;
  for (int c = 0; c < 3; c++) channel[c] = values(stone_channels[c], points);
  for (std::size_t i = 0; i < points.size(); i++) {
    const bool grey = std::abs(channel[0][i] - channel[2][i]) < 0.01f;
    (grey ? mortar : red).push_back(channel[0][i]);
    if (grey) continue;
    EXPECT_GT(channel[0][i], 0.55f);
    EXPECT_LT(channel[0][i], 0.88f);
    EXPECT_GT(channel[1][i], 0.24f);
    EXPECT_LT(channel[1][i], 0.46f);
    EXPECT_GT(channel[2][i], 0.0f);
    EXPECT_LT(channel[2][i], 0.33f);
  }
  const double share = static_cast<double>(mortar.size()) / static_cast<double>(points.size());
  EXPECT_NEAR(share, 0.19, 0.015 + share_tolerance(0.19, points.size()));
  const Moments grey = moments(mortar);
  EXPECT_NEAR(grey.mean, 0.60, 0.005);
  EXPECT_NEAR(grey.deviation, 0.028, 0.004);
  std::sort(red.begin(), red.end());
  EXPECT_NEAR(red[red.size() / 2], 0.82, 0.01);
}

// Every instruction set, and every company of other points, gives the same bits.
TEST(Texture, PointsAreOnTheirOwn) {
  Points points = random_points(scaled(20011, 1003), 30);
  for (const double x : {0.0, 1e-30, 1.0, -1.0, 1e6, -3e9, 1e30}) points.add(x, -x, x / 3);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  Points shuffled;
  for (const std::size_t i : order) shuffled.add(points.x[i], points.y[i], points.z[i]);
  for (const LaneFunction function :
       {LaneFunction::wood_red, LaneFunction::wood_green, LaneFunction::wood_blue, LaneFunction::marble,
        LaneFunction::stone_red, LaneFunction::stone_green, LaneFunction::stone_blue, LaneFunction::stone_border}) {
    const std::vector<float> first = values(function, points, *usable_kernels().front());
    for (const Kernel* kernel : usable_kernels()) {
      const std::vector<float> straight = values(function, points, *kernel),
                               mixed = values(function, shuffled, *kernel);
      int different = 0;
      for (std::size_t i = 0; i < order.size(); i++) {
        const auto expected = std::bit_cast<std::uint32_t>(first[order[i]]);
        different += expected != std::bit_cast<std::uint32_t>(straight[order[i]]);
        different += expected != std::bit_cast<std::uint32_t>(mixed[i]);
      }
      EXPECT_EQ(different, 0) << kernel->isa << " function " << static_cast<int>(function);
    }
  }
}

TEST(Texture, PicturesAreTheSameForEveryInstructionSet) {
  const std::string text =
      "image_size 61 47\nrays_per_pixel 5\nlight 3 5 2 1 1 1\n"
      "wood\nsphere 0.8 -1 0.4 -4\nmarble\nsphere 0.8 0.9 0.5 -4\nstone\nsphere 0.8 0 -0.7 -3.5\nnoise 3\n"
      "box -2 -2 -6 2 -1.5 -3\nwood\nbegin\nvertex -4 -4 -7\nvertex 4 -4 -7\nvertex 0 5 -7\nend\n";
  RenderSettings settings;
  settings.kernel = usable_kernels().front();
  const Picture3 first = render_text(text, settings);
  for (const Kernel* kernel : usable_kernels()) {
    settings.kernel = kernel;
    EXPECT_EQ(render_text(text, settings).color, first.color) << kernel->isa;
  }
}

// What is seen straight on, in the light of a lamp behind the eye, is the diffuse colour itself.
Vec3 seen(const std::string& ball, Vec3 point, Vec3 outward) {
  return color_of(look(point + outward * 2, -outward) + "light " + numbers(point + outward * 5) + " 1 1 1\n" + ball);
}

Vec3 texture_at(const std::string& name, Vec3 p) {
  Points point;
  point.add(p.x, p.y, p.z);
  if (name == "marble") return Vec3{1, 1, 1} * double{values(LaneFunction::marble, point)[0]};
  const auto& channels = name == "wood" ? wood_channels : stone_channels;
  return {values(channels[0], point)[0], values(channels[1], point)[0], values(channels[2], point)[0]};
}

// A unit ball in many directions d: seen at `world(d)` with the normal `normal(d)`, its colour is that of the block at
// `block(d)`. Where an edge runs through the point, rounding may choose the other side: at most one point in twenty.
template <typename World, typename Normal, typename Block>
void expect_texture(const std::string& name, const std::string& ball, World world, Normal normal, Block block) {
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  constexpr int count = scaled(40, 20);
  int different = 0;
  for (int i = 0; i < count; i++) {
    const double x = any(random), y = any(random);
    const Vec3 d = normalize({x, y, any(random)});
    const Vec3 difference = abs(seen(ball, world(d), normal(d)) - texture_at(name, block(d)));
    different += max_component(difference) > 2e-3;
  }
  EXPECT_LE(different, count / 20) << ball;
}

TEST(Texture, IsCutFromTheSpaceOfTheDefinition) {
  const auto same = [](Vec3 d) { return d; };
  const auto quarter = [](Vec3 d) { return Vec3{-d.y, d.x, d.z}; };  // rotatez 90
  for (const std::string name : {"wood", "marble", "stone"}) {
    const std::string surface = "diffuse 0.9 0.1 0.1 0 0 0\n" + name + "\n";
    expect_texture(name, surface + "sphere 1 0 0 0\n", same, same, same);
    // The matrix of the definition moves the ball through the block.
    const auto shifted = [](Vec3 d) { return d + Vec3{0.4, -2, 1.3}; };
    expect_texture(name, surface + "translate 0.4 -2 1.3\nsphere 1 0 0 0\n", shifted, same, shifted);
    expect_texture(name, surface + "rotatez 90\nsphere 1 0 0 0\n", same, same, same);
    // An instance carries the block along, whatever it holds.
    const auto placed = [&](Vec3 d) { return quarter(d) + Vec3{3, 1, 0}; };
    const std::string place = "named_object it\ntranslate 3 1 0\nrotatez 90\ninstance it\n";
    expect_texture(name, surface + "sphere 1 0 0 0\n" + place, placed, quarter, same);
    expect_texture(name, surface + "begin_list\nsphere 1 0 0 0\nend_list\n" + place, placed, quarter, same);
    // So does motion.
    const auto moved = [](Vec3 d) { return d + Vec3{0.5, 0, -1}; };
    expect_texture(name, "shutter 0.5 0.5\n" + surface + "sphere 1 0 0 0\nmoving_object 1 0 -2\n", moved, same, same);
  }
}

}  // namespace
}  // namespace penumbra::test
