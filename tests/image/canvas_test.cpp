// Shapes cover the areas they should, where they should.
#include "image/canvas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace penumbra {
namespace {

constexpr Canvas::Color white = {1, 1, 1}, black = {0, 0, 0};

float value(const Image& image, int x, int y) { return image.rgb[3 * static_cast<std::size_t>(y * image.width + x)]; }

// The white area on black, in pixels.
double area(const Image& image) {
  double sum = 0;
  for (const float v : image.rgb) sum += v;
  return sum / 3;
}

TEST(Canvas, ADiskHasItsArea) {
  for (const double radius : {2.0, 5.3, 20.0}) {
    Canvas canvas(64, 48, black);
    canvas.disk({31.3, 24.6}, radius, white);
    const Image image = canvas.take();
    // The ramp adds a little more outside than it removes inside.
    EXPECT_NEAR(area(image), std::numbers::pi * (radius * radius + 1.0 / 12), 0.1 + 0.01 * radius);
    EXPECT_EQ(value(image, 31, 24), 1);
    EXPECT_EQ(value(image, 1, 1), 0);
  }
}

TEST(Canvas, ARingHasItsArea) {
  Canvas canvas(64, 48, black);
  canvas.ring({30, 25}, 15, 2, white);
  const Image image = canvas.take();
  EXPECT_NEAR(area(image), 2 * std::numbers::pi * 15 * 2, 1);
  EXPECT_EQ(value(image, 30, 25), 0);
}

TEST(Canvas, ALineHasItsArea) {
  Canvas canvas(64, 48, black);
  canvas.line({10, 10}, {50, 40}, 3, white);
  EXPECT_NEAR(area(canvas.take()), 3 * 50 + std::numbers::pi * 1.5 * 1.5, 1);
}

TEST(Canvas, ALineAlongPixelsIsSharp) {
  Canvas canvas(20, 10, black);
  canvas.line({0.5, 4.5}, {19.5, 4.5}, 1, white);
  const Image image = canvas.take();
  for (int x = 1; x < 19; x++) {
    EXPECT_EQ(value(image, x, 3), 0);
    EXPECT_EQ(value(image, x, 4), 1);
    EXPECT_EQ(value(image, x, 5), 0);
  }
}

// Half-covered pixels of a joint are not painted twice: a curve there and back equals the line.
TEST(Canvas, JointsArePaintedOnce) {
  Canvas once(30, 20, black), twice(30, 20, black);
  once.curve({{4, 5}, {25, 15}}, 2, white);
  twice.curve({{4, 5}, {25, 15}, {4, 5}}, 2, white);
  EXPECT_EQ(once.take(), twice.take());
}

TEST(Canvas, NothingIsDrawnOutsideTheClip) {
  Canvas canvas(30, 20, black);
  canvas.clip_to({5, 6, 15, 12});
  canvas.disk({10, 10}, 100, white);
  canvas.ring({0, 0}, 20, 3, white);
  canvas.curve({{-50, -50}, {100, 90}, {0, 300}}, 4, white);
  EXPECT_EQ(area(canvas.take()), 10 * 6);
}

TEST(Canvas, ShapesMayLeaveThePicture) {
  Canvas canvas(8, 8, black);
  canvas.disk({-3, 20}, 5, white);
  canvas.line({-20, -20}, {-10, 40}, 2, white);
  canvas.number({30, -9}, 9, "12", white);
  EXPECT_EQ(area(canvas.take()), 0);
  Canvas all(8, 8, black);
  all.disk({4, 4}, 100, white);
  EXPECT_EQ(area(all.take()), 64);
}

// Every character is drawn, each differently, inside its box.
TEST(Canvas, DigitsDiffer) {
  std::vector<Image> drawn;
  for (const char character : std::string("0123456789.-")) {
    Canvas canvas(20, 20, black);
    canvas.number({10, 10}, 12, std::string(1, character), white);
    const Image image = canvas.take();
    EXPECT_GT(area(image), 0.5) << character;
    for (int i = 0; i < 20; i++) {
      EXPECT_EQ(value(image, i, 1), 0);
      EXPECT_EQ(value(image, i, 18), 0);
      EXPECT_EQ(value(image, 3, i), 0);
      EXPECT_EQ(value(image, 16, i), 0);
    }
    for (const Image& other : drawn) EXPECT_NE(image, other) << character;
    drawn.push_back(image);
  }
}

}  // namespace
}  // namespace penumbra
