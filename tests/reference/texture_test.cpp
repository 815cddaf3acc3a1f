// The pairs with solid textures, where the picture shows the texture. Wood reproduces the published rings almost pixel
// for pixel; the random numbers behind the published marble and stone are unknown, so these two are compared as
// materials: the distribution of colours, and how fast they change from place to place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vec.hpp"
#include "reference/pair.hpp"

namespace penumbra::test {
namespace {

// The part of the unit ball at (0, 0, -4) that is lit well enough to recover the diffuse colour from 8 bits.
struct LitBall {
  static constexpr int size = 600;
  static constexpr double dimmest = 0.3;
  std::vector<double> light = std::vector<double>(std::size_t{size} * size);  // zero elsewhere

  LitBall() {
    const double scale = 2 * std::tan(30 * M_PI / 180) / size;
    for (int y = 1; y < size; y++) {
      for (int x = 0; x < size; x++) {
        const Vec3 d{(x - size / 2) * scale, (size / 2 - y) * scale, -1}, center{0, 0, -4};
        const double b = dot(d, center), discriminant = b * b - dot(d, d) * 15;
        if (discriminant <= 0) continue;
        const Vec3 p = d * ((b - std::sqrt(discriminant)) / dot(d, d)), n = p - center;
        const double sum = 0.5 * std::max(0.0, dot(n, normalize(Vec3{-3, 5, 5} - p))) +
                           std::max(0.0, dot(n, normalize(Vec3{5, 3, 3} - p)));
        if (sum > dimmest) light[index(x, y)] = sum;
      }
    }
  }
  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x); }
  bool covers(int x, int y) const { return light[index(x, y)] > 0; }
  double diffuse(const Levels& picture, int x, int y, int channel) const {
    return (picture.at(x, y, channel) + 0.5) / 255 / light[index(x, y)];
  }
};

struct Look {
  double mean = 0, deviation = 0;
  std::vector<double> percentiles;  // 5, 10, ..., 95
  std::vector<double> changes;      // root mean square over 1, 4, 16 pixels, in deviations
};

Look look_of(const LitBall& ball, const Levels& picture, int channel) {
  std::vector<double> all;
  for (int y = 0; y < LitBall::size; y++) {
    for (int x = 0; x < LitBall::size; x++) {
      if (ball.covers(x, y)) all.push_back(ball.diffuse(picture, x, y, channel));
    }
  }
  Look look;
  const auto n = static_cast<double>(all.size());
  for (const double v : all) look.mean += v / n;
  for (const double v : all) look.deviation += (v - look.mean) * (v - look.mean) / n;
  look.deviation = std::sqrt(look.deviation);
  std::sort(all.begin(), all.end());
  for (std::size_t p = 5; p < 100; p += 5) look.percentiles.push_back(all[all.size() * p / 100]);
  for (const int lag : {1, 4, 16}) {
    double sum = 0, count = 0;
    for (int y = 0; y + lag < LitBall::size; y++) {
      for (int x = 0; x + lag < LitBall::size; x++) {
        if (!ball.covers(x, y)) continue;
        const double here = ball.diffuse(picture, x, y, channel);
        for (const auto& [i, j] : {std::pair{x + lag, y}, std::pair{x, y + lag}}) {
          if (!ball.covers(i, j)) continue;
          const double change = ball.diffuse(picture, i, j, channel) - here;
          sum += change * change;
          count++;
        }
      }
    }
    look.changes.push_back(std::sqrt(sum / count) / look.deviation);
  }
  return look;
}

struct TexturePair {
  Levels published, ours;
};

std::optional<TexturePair> render_pair(const std::string& name) {
  const auto folder = reference_folder();
  if (!folder || reference_entry(*folder, name).is_null()) return std::nullopt;
  return TexturePair{read_levels(*folder / name / "reference.png"),
                     render_levels(*folder / name / "scene.cli", "--size 600x600 --threads 1")};
}

// Of the mean, the deviation, a percentile, and the changes (relative).
struct Tolerance {
  double mean, deviation, percentile, change;
};

void expect_same_material(const TexturePair& pair, const Tolerance& tolerance) {
  const LitBall ball;
  for (int channel = 0; channel < 3; channel++) {
    const Look published = look_of(ball, pair.published, channel), ours = look_of(ball, pair.ours, channel);
    EXPECT_NEAR(ours.mean, published.mean, tolerance.mean) << "channel " << channel;
    EXPECT_NEAR(ours.deviation, published.deviation, tolerance.deviation) << "channel " << channel;
    // A step of the distribution may be at a slightly different percentile: the nearest of three counts.
    for (std::size_t i = 0; i < ours.percentiles.size(); i++) {
      double distance = 1;
      for (std::size_t j = i == 0 ? 0 : i - 1; j < std::min(i + 2, ours.percentiles.size()); j++) {
        distance = std::min(distance, std::abs(ours.percentiles[i] - published.percentiles[j]));
      }
      EXPECT_LT(distance, tolerance.percentile) << "channel " << channel << ", percentile " << 5 * (i + 1);
    }
    for (std::size_t i = 0; i < ours.changes.size(); i++) {
      EXPECT_NEAR(ours.changes[i] / published.changes[i], 1, tolerance.change)
          << "channel " << channel << ", lag " << i;
    }
  }
}

TEST(TexturePair, Wood) {
  const auto pair = render_pair("29-4-wood");
  if (!pair) GTEST_SKIP() << "no published picture of wood";
  expect_same_material(*pair, {0.01, 0.01, 0.01, 0.03});
  const LitBall ball;
  int same = 0, total = 0;
  for (int y = 0; y < LitBall::size; y++) {
    for (int x = 0; x < LitBall::size; x++) {
      if (!ball.covers(x, y)) continue;
      same += (ball.diffuse(pair->ours, x, y, 0) > 0.45) == (ball.diffuse(pair->published, x, y, 0) > 0.45);
      total++;
    }
  }
  EXPECT_GT(same, 0.92 * total) << "light and dark wood in the same places";
}

TEST(TexturePair, Marble) {
  const auto pair = render_pair("30-4-marble");
  if (!pair) GTEST_SKIP() << "no published picture of marble";
  expect_same_material(*pair, {0.03, 0.015, 0.05, 0.08});
}

// Counts the stones of a picture that are larger than 20 pixels.
int count_stones(const LitBall& ball, const Levels& picture) {
  std::vector<bool> open(ball.light.size());
  for (int y = 0; y < LitBall::size; y++) {
    for (int x = 0; x < LitBall::size; x++) {
      open[LitBall::index(x, y)] =
          ball.covers(x, y) && ball.diffuse(picture, x, y, 0) - ball.diffuse(picture, x, y, 2) > 0.1;
    }
  }
  int stones = 0;
  for (std::size_t start = 0; start < open.size(); start++) {
    if (!open[start]) continue;
    std::vector<std::size_t> border{start};
    open[start] = false;
    int pixels = 0;
    while (!border.empty()) {
      const std::size_t at = border.back();
      border.pop_back();
      pixels++;
      for (const std::size_t next : {at - 1, at + 1, at - LitBall::size, at + LitBall::size}) {
        if (next < open.size() && open[next]) {
          open[next] = false;
          border.push_back(next);
        }
      }
    }
    stones += pixels > 20;
  }
  return stones;
}

TEST(TexturePair, Stone) {
  const auto pair = render_pair("31-4-stone");
  if (!pair) GTEST_SKIP() << "no published picture of stone";
  expect_same_material(*pair, {0.03, 0.02, 0.06, 0.08});
  const LitBall ball;
  const int published = count_stones(ball, pair->published), ours = count_stones(ball, pair->ours);
  EXPECT_NEAR(ours, published, 0.2 * published);
}

}  // namespace
}  // namespace penumbra::test
