// The heat map: black for no difference, brightest for the scale, and always lighter for more.

#include <gtest/gtest.h>

#include <limits>

#include "image/comparison.hpp"

namespace penumbra {
namespace {

TEST(Heatmap, IsLighterForMore) {
  const int steps = 1000;
  std::vector<float> differences;
  for (int i = 0; i <= steps; i++) differences.push_back(static_cast<float>(i));
  const Image image = heatmap(differences, steps + 1, 1, static_cast<float>(steps));
  const std::vector<float> light = luma(image);
  EXPECT_EQ(light.front(), 0);
  EXPECT_GT(light.back(), 0.9f);
  for (std::size_t i = 1; i < light.size(); i++) EXPECT_GT(light[i], light[i - 1]) << i;
}

TEST(Heatmap, NothingIsBlackAndTooMuchIsBrightest) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Image image = heatmap({0, 2, 3, infinity}, 2, 2, 2);
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.rgb[0] + image.rgb[1] + image.rgb[2], 0);
  for (std::size_t i = 6; i < 12; i++) EXPECT_EQ(image.rgb[i], image.rgb[i - 3]);
  const Image same = heatmap({0, infinity}, 2, 1, 0);
  EXPECT_EQ(same.rgb[0], 0);
  EXPECT_EQ(same.rgb[3], 1);
}

}  // namespace
}  // namespace penumbra
