// Rounding of colours to integers, against integer arithmetic.
#include "image/quantize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace penumbra {
namespace {

TEST(Quantize, TheCoursesNumbers) {
  EXPECT_EQ(quantize_8(0.2f, Rounding::course), 51);
  EXPECT_EQ(quantize_8(std::nextafter(0.2f, 0.0f), Rounding::course), 51);
  EXPECT_EQ(quantize_8(0.3f, Rounding::course), 76);
  EXPECT_EQ(quantize_8(0.5f, Rounding::course), 127);
  EXPECT_EQ(quantize_8(0.9f, Rounding::course), 229);
  EXPECT_EQ(quantize_8(1.0f, Rounding::course), 255);
  EXPECT_EQ(quantize_8(0.9999f, Rounding::course), 254);
}

TEST(Quantize, TheNearestNumbers) {
  EXPECT_EQ(quantize_8(0.2f), 51);
  EXPECT_EQ(quantize_8(0.3f), 77);
  EXPECT_EQ(quantize_8(0.5f), 128);
  EXPECT_EQ(quantize_8(0.9f), 229);
  EXPECT_EQ(quantize_8(0.5f / 255), 1);
  EXPECT_EQ(quantize_8(std::nextafter(0.5f / 255, 0.0f)), 0);
}

// 255 n / 100000 + 1e-4 = (255 n + 10) / 100000, exactly. A float is within 6e-8 of n/100000, which moves the value by
// less than 2e-5. As all values are multiples of 5e-5, that cannot reach an integer.
TEST(Quantize, EveryFiveDigitDecimalOfTheCourse) {
  for (int n = 0; n <= 100000; n++) {
    const int expected = (255 * n + 10) / 100000;
    if ((255 * n + 10) % 100000 == 0) continue;  // exactly on the edge, which no float can be
    ASSERT_EQ(quantize_8(static_cast<float>(n / 100000.0), Rounding::course), expected) << n;
  }
}

TEST(Quantize, WhatAFileHoldsComesBack) {
  for (int n = 0; n < 256; n++) {
    ASSERT_EQ(quantize_8(static_cast<float>(n) / 255.0f), n);
    ASSERT_EQ(quantize_8(static_cast<float>(n) / 255.0f, Rounding::course), n);
  }
  for (int n = 0; n < 65536; n++) ASSERT_EQ(quantize_16(static_cast<float>(n) / 65535.0f), n);
}

TEST(Quantize, WhatIsBeyondIsClamped) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const Rounding rounding : {Rounding::nearest, Rounding::course}) {
    EXPECT_EQ(quantize_8(-1.0f, rounding), 0);
    EXPECT_EQ(quantize_8(-infinity, rounding), 0);
    EXPECT_EQ(quantize_8(std::nanf(""), rounding), 0);
    EXPECT_EQ(quantize_8(1.001f, rounding), 255);
    EXPECT_EQ(quantize_8(1e30f, rounding), 255);
    EXPECT_EQ(quantize_8(infinity, rounding), 255);
    EXPECT_EQ(quantize_16(infinity, rounding), 65535);
    EXPECT_EQ(quantize_16(std::nanf(""), rounding), 0);
  }
}

}  // namespace
}  // namespace penumbra
