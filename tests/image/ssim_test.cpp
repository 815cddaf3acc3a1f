// SSIM against closed forms, and against scikit-image 0.19: structural_similarity(a, b, gaussian_weights=True,
// sigma=1.5, use_sample_covariance=False, data_range=1) on the luma of the same pictures.

#include <gtest/gtest.h>

#include <cmath>

#include "image/metrics.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

TEST(Ssim, EqualPicturesGiveOne) {
  EXPECT_EQ(ssim(test::pattern(40, 30), test::pattern(40, 30)), 1.0);
  EXPECT_EQ(ssim(test::flat(12, 12, 0, 0, 0), test::flat(12, 12, 0, 0, 0)), 1.0);
}

TEST(Ssim, FlatPicturesGiveTheLuminanceTerm) {
  const double a = 0.4f, b = 0.6f, c1 = 1e-4;
  EXPECT_NEAR(ssim(test::flat(20, 15, 0.4f, 0.4f, 0.4f), test::flat(20, 15, 0.6f, 0.6f, 0.6f)),
              (2 * a * b + c1) / (a * a + b * b + c1), 1e-6);
}

TEST(Ssim, AnInvertedPictureIsLessThanZero) {
  Image image = test::pattern(40, 40), inverted = image;
  for (float& v : inverted.rgb) v = 1 - v;
  EXPECT_LT(ssim(image, inverted), -0.5);
}

TEST(Ssim, IsSymmetric) {
  const Image a = test::pattern(40, 30), b = test::pattern(40, 30, 20);
  EXPECT_DOUBLE_EQ(ssim(a, b), ssim(b, a));
}

TEST(Ssim, AgreesWithScikitImage) {
  EXPECT_NEAR(ssim(test::pattern(64, 48), test::pattern(64, 48, 20)), 0.786981399848, 2e-6);
  EXPECT_NEAR(ssim(test::pattern(64, 48), test::pattern(64, 48, 3)), 0.964620085692, 2e-6);
  EXPECT_NEAR(ssim(test::pattern(30, 90), test::pattern(30, 90, 100)), 0.369121268443, 2e-6);
}

TEST(Ssim, SmallPicturesHaveAFigureToo) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {3, 40}, {10, 10}, {11, 11}}) {
    EXPECT_EQ(ssim(test::pattern(width, height), test::pattern(width, height)), 1.0);
    const double other = ssim(test::pattern(width, height), test::flat(width, height, 1, 1, 1));
    EXPECT_LT(other, 0.9);
    EXPECT_GT(other, -1.0);
  }
}

}  // namespace
}  // namespace penumbra
