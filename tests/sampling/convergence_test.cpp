// How fast the error of a mean falls with the number of points, and that numbers that are not squares are no worse than
// squares. What theory says about the variance of N points in the plane, for smooth functions and for edges:
//   random         N^-1    N^-1
//   jittered       N^-2    N^-3/2   as in the lecture: one point in each cell
//   multijittered  N^-3/2  N^-3/2   for edges always below jittered, for smooth functions up to about 100 points;
//                                   then the shared orders of cells cost more than columns and rows save
//   poisson        between N^-1 and N^-3/2: low frequencies are weaker than in random points, but present
//   halton         N^-2    N^-3/2   between the counts 2^a 3^b
//   sobol          N^-3    N^-3/2   up to powers of log N (Owen 1997)
//   bluenoise      N^-3    N^-3/2   as sobol
// The bounds are at least five standard errors of the measurement away from what correct points give.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "base/test_scale.hpp"
#include "sampling/integrands.hpp"
#include "sampling/points.hpp"

namespace penumbra::test {
namespace {

// Sets of `count` points, identified by a number.
using Generator = std::function<Points(std::uint32_t count, int number)>;

// Some patterns need a table for each seed.
constexpr int seeds = 16;
const std::vector<Frame>& frames_of(Pattern pattern, std::uint32_t count) {
  static std::map<std::pair<Pattern, std::uint32_t>, std::vector<Frame>> made;
  std::vector<Frame>& frames = made[{pattern, count}];
  for (auto seed = static_cast<std::uint32_t>(frames.size()); seed < seeds; seed++) {
    frames.push_back(sampling_frame(pattern, count, seed + 100));
  }
  return frames;
}

Generator points_of_pattern(Pattern pattern, Dimensions dimensions) {
  return [pattern, dimensions](std::uint32_t count, int number) {
    const int pixel = number / seeds;
    const Frame& frame = frames_of(pattern, count)[static_cast<std::size_t>(number % seeds)];
    return points_of(frame, pixel % 64, pixel / 64, dimensions, count);
  };
}

template <typename Function>
struct Functions {
  std::vector<Function> list;
  std::vector<double> means;

  explicit Functions(std::vector<Function> functions) : list(std::move(functions)) {
    for (const Function& function : list) means.push_back(function.mean());
  }
};

const Functions<Bump>& bumps() {
  static const Functions<Bump> functions(random_bumps(8));
  return functions;
}
const Functions<Edge>& edges() {
  static const Functions<Edge> functions(random_edges(50));
  return functions;
}

// The mean squared error of the mean over `count` points, averaged over the functions and many sets. It includes any
// bias: points that are not uniform do not converge.
template <typename Function>
double variance(const Generator& generator, const Functions<Function>& functions, std::uint32_t count, int sets) {
  double total = 0;
  for (int number = 0; number < sets; number++) {
    const Points points = generator(count, number);
    for (std::size_t i = 0; i < functions.list.size(); i++) {
      const Function function = functions.list[i];
      float sum = 0;
      for (std::uint32_t k = 0; k < count; k++) sum += function(points.u[k], points.v[k]);
      const double error = double{sum} / count - functions.means[i];
      total += error * error;
    }
  }
  return total / (static_cast<double>(functions.list.size()) * sets);
}

// The slope of the straight line through the logarithms of variance and count, 16 to 1024.
template <typename Function>
double slope(const Generator& generator, const Functions<Function>& functions, int sets) {
  double sum = 0, squares = 0;
  for (int i = -3; i <= 3; i++) {
    sum += i * std::log2(variance(generator, functions, 1024u >> (3 - i), sets));
    squares += i * i;
  }
  return sum / squares;
}

// The variance with 50 rays divided by that with 49, which are 7 by 7: about 49/50 if nothing is wrong.
template <typename Function>
double fifty_against_square(const Generator& generator, const Functions<Function>& functions, int sets) {
  return variance(generator, functions, 50, sets) / variance(generator, functions, 49, sets);
}

constexpr int slope_sets = scaled(1600, 400), random_sets = scaled(4000, 800), ratio_sets = scaled(12800, 3200);
constexpr double worst_ratio = 1.1;
constexpr double most_left = 0.65;  // of the variance, with twice as many points

struct Bounds {
  Pattern pattern;
  double smooth, edges;  // upper bounds of the slopes
};
constexpr Bounds all_bounds[] = {{Pattern::regular, -1.9, -1.4},       {Pattern::jittered, -1.9, -1.4},
                                 {Pattern::multijittered, -1.4, -1.4}, {Pattern::poisson, -1.1, -1.15},
                                 {Pattern::halton, -1.9, -1.4},        {Pattern::sobol, -2.4, -1.4},
                                 {Pattern::bluenoise, -2.4, -1.4}};

class Convergence : public testing::TestWithParam<Pattern> {
 protected:
  static constexpr Dimensions measured[] = {{pixel_x}, {0x2c1b3c6du}};
};

TEST_P(Convergence, ErrorFallsAsFastAsTheorySays) {
  for (const Dimensions dimensions : measured) {
    const Generator generator = points_of_pattern(GetParam(), dimensions);
    if (GetParam() == Pattern::random) {
      const double smooth = slope(generator, bumps(), random_sets), edge = slope(generator, edges(), random_sets / 2);
      RecordProperty("slopes_" + std::to_string(dimensions.first), std::to_string(smooth) + " " + std::to_string(edge));
      EXPECT_NEAR(smooth, -1, 0.05) << dimensions.first;
      EXPECT_NEAR(edge, -1, 0.05) << dimensions.first;
      continue;
    }
    const double smooth = slope(generator, bumps(), slope_sets), edge = slope(generator, edges(), slope_sets / 2);
    RecordProperty("slopes_" + std::to_string(dimensions.first), std::to_string(smooth) + " " + std::to_string(edge));
    for (const Bounds& bounds : all_bounds) {
      if (bounds.pattern != GetParam()) continue;
      EXPECT_LT(smooth, bounds.smooth) << dimensions.first;
      EXPECT_LT(edge, bounds.edges) << dimensions.first;
    }
  }
}

// Every pattern is better than random points, even at 16 points.
TEST_P(Convergence, ErrorIsBelowThatOfRandomPoints) {
  if (GetParam() == Pattern::random) GTEST_SKIP() << "random points";
  const Generator random = points_of_pattern(Pattern::random, {pixel_x});
  for (const Dimensions dimensions : measured) {
    const Generator generator = points_of_pattern(GetParam(), dimensions);
    for (const std::uint32_t count : {16u, 50u}) {
      EXPECT_LT(variance(generator, bumps(), count, slope_sets), variance(random, bumps(), count, slope_sets) * 0.5);
      EXPECT_LT(variance(generator, edges(), count, slope_sets), variance(random, edges(), count, slope_sets) * 0.5);
    }
  }
}

TEST_P(Convergence, FiftyRaysAreAsGoodAsTheyShouldBe) {
  if (GetParam() == Pattern::regular) GTEST_SKIP() << "a single set of points: the ratio is a matter of luck";
  for (const Dimensions dimensions : measured) {
    const Generator generator = points_of_pattern(GetParam(), dimensions);
    const double smooth = fifty_against_square(generator, bumps(), ratio_sets);
    const double edge = fifty_against_square(generator, edges(), ratio_sets / 2);
    RecordProperty("ratios_" + std::to_string(dimensions.first), std::to_string(smooth) + " " + std::to_string(edge));
    EXPECT_LT(smooth, worst_ratio) << dimensions.first;
    EXPECT_LT(edge, worst_ratio) << dimensions.first;
  }
}

// Twice as many points are always better, even where the rows of cells differ in length.
TEST_P(Convergence, MorePointsAreBetter) {
  const Generator generator = points_of_pattern(GetParam(), {pixel_x});
  double before = 1, edge_before = 1;
  for (std::uint32_t count = 4; count <= 512; count *= 2) {
    const double smooth = variance(generator, bumps(), count, slope_sets);
    const double edge = variance(generator, edges(), count, slope_sets / 2);
    EXPECT_LT(smooth, most_left * before) << count;
    EXPECT_LT(edge, most_left * edge_before) << count;
    before = smooth;
    edge_before = edge;
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, Convergence, testing::ValuesIn(all_patterns),
                         [](const auto& p) { return name_of(p.param); });

// --- Defects that the measurements notice. ---

Generator jittered() { return points_of_pattern(Pattern::jittered, {pixel_x}); }
Generator random_points() { return points_of_pattern(Pattern::random, {pixel_x}); }

TEST(ConvergenceChecks, NoticeRandomPoints) {
  EXPECT_GT(slope(random_points(), bumps(), slope_sets / 4), -1.9);
  EXPECT_GT(slope(random_points(), edges(), slope_sets / 4), -1.4);
}

// One point in ten is anywhere.
TEST(ConvergenceChecks, NoticeAFewRandomPoints) {
  const auto mixed = [stratified = jittered(), random = random_points()](std::uint32_t count, int number) {
    Points points = stratified(count, number);
    const Points others = random(count, number);
    for (std::size_t i = 0; i < count; i += 10) {
      points.u[i] = others.u[i];
      points.v[i] = others.v[i];
    }
    return points;
  };
  EXPECT_GT(slope(mixed, bumps(), slope_sets / 4), -1.9);
  EXPECT_GT(slope(mixed, edges(), slope_sets / 4), -1.4);
}

// Corners of cells instead of places in them: the mean itself is off.
TEST(ConvergenceChecks, NoticeTruncatedNumbers) {
  const auto truncated = [stratified = jittered()](std::uint32_t count, int number) {
    Points points = stratified(count, number);
    for (float& u : points.u) u = std::floor(u * 64) / 64;
    return points;
  };
  EXPECT_GT(slope(truncated, bumps(), slope_sets / 4), -1.9);
}

// 7 by 7 cells, and the fiftieth point anywhere.
TEST(ConvergenceChecks, NoticeALeftOverPoint) {
  const auto left_over = [stratified = jittered(), random = random_points()](std::uint32_t count, int number) {
    const auto side = static_cast<std::uint32_t>(std::sqrt(count));
    Points points = stratified(side * side, number);
    const Points others = random(count, number);
    points.u.insert(points.u.end(), others.u.begin() + side * side, others.u.end());
    points.v.insert(points.v.end(), others.v.begin() + side * side, others.v.end());
    return points;
  };
  EXPECT_GT(fifty_against_square(left_over, bumps(), ratio_sets / 2), worst_ratio);
}

// Half as many points, each twice.
TEST(ConvergenceChecks, NoticePointsDrawnTwice) {
  const auto twice = [stratified = jittered()](std::uint32_t count, int number) {
    Points points = stratified(count / 2, number);
    const Points same = points;
    points.u.insert(points.u.end(), same.u.begin(), same.u.end());
    points.v.insert(points.v.end(), same.v.begin(), same.v.end());
    return points;
  };
  EXPECT_GT(variance(Generator(twice), bumps(), 128, slope_sets),
            most_left * variance(jittered(), bumps(), 64, slope_sets));
}

}  // namespace
}  // namespace penumbra::test
