// The plain figures against closed forms, and the verdicts of a comparison against their definition.
#include "image/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/comparison.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

const float infinity = std::numeric_limits<float>::infinity();
const float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Metrics, EqualPictures) {
  const Image image = test::pattern(33, 21);
  const ErrorFigures figures = error_figures(image, image);
  EXPECT_EQ(figures.mean_absolute_error, 0);
  EXPECT_EQ(figures.rmse, 0);
  EXPECT_EQ(figures.psnr, std::numeric_limits<double>::infinity());
  EXPECT_EQ(count_beyond(pixel_differences(image, image), 0), 0u);
}

TEST(Metrics, AConstantDifference) {
  const ErrorFigures figures = error_figures(test::flat(7, 5, 0.25f, 0.5f, 0.5f), test::flat(7, 5, 0.5f, 0.25f, 0.75f));
  EXPECT_DOUBLE_EQ(figures.mean_absolute_error, 0.25);
  EXPECT_DOUBLE_EQ(figures.rmse, 0.25);
  EXPECT_DOUBLE_EQ(figures.psnr, -20 * std::log10(0.25));
}

TEST(Metrics, OneValueOfMany) {
  const Image a = test::flat(10, 10, 0.5f, 0.5f, 0.5f);
  Image b = a;
  b.rgb[3 * 42 + 1] = 0.75f;
  const ErrorFigures figures = error_figures(a, b);
  EXPECT_DOUBLE_EQ(figures.mean_absolute_error, 0.25 / 300);
  EXPECT_DOUBLE_EQ(figures.rmse, 0.25 / std::sqrt(300));
  const std::vector<float> differences = pixel_differences(a, b);
  for (std::size_t i = 0; i < 100; i++) EXPECT_EQ(differences[i], i == 42 ? 0.25f : 0.0f);
  EXPECT_EQ(count_beyond(differences, 0.25f), 0u);
  EXPECT_EQ(count_beyond(differences, 0.24f), 1u);
}

TEST(Metrics, ThePeakOfBrightPicturesIsTheirLargestValue) {
  const ErrorFigures figures = error_figures(test::flat(2, 2, 8, 0, 0), test::flat(2, 2, 10, 0, 0));
  EXPECT_DOUBLE_EQ(figures.rmse, std::sqrt(4 / 3.0));
  EXPECT_DOUBLE_EQ(figures.psnr, 20 * std::log10(10 / std::sqrt(4 / 3.0)));
}

TEST(Metrics, WhatIsNotFinite) {
  EXPECT_EQ(difference(nan, nan), 0);
  EXPECT_EQ(difference(infinity, infinity), 0);
  EXPECT_EQ(difference(infinity, -infinity), infinity);
  EXPECT_EQ(difference(nan, 1), infinity);
  EXPECT_EQ(difference(1, nan), infinity);
  EXPECT_EQ(difference(nan, infinity), infinity);
  EXPECT_EQ(difference(1, infinity), infinity);
  const std::vector<float> differences{0, 1, infinity};
  EXPECT_EQ(count_beyond(differences, infinity), 1u);
  EXPECT_EQ(largest_finite(differences), 1);
  const ErrorFigures figures = error_figures(test::flat(2, 2, 0, nan, 0.5f), test::flat(2, 2, 0.5f, 0, 0.5f));
  EXPECT_EQ(figures.mean_absolute_error, infinity);
  EXPECT_EQ(figures.rmse, infinity);
  EXPECT_EQ(figures.psnr, -infinity);
  const Image same = test::flat(2, 2, nan, infinity, 0.5f);
  EXPECT_EQ(error_figures(same, same).rmse, 0);
  EXPECT_EQ(count_not_finite(same), 4u);
  EXPECT_EQ(count_not_finite(test::flat(2, 2, 1, 3e38f, -1)), 0u);
}

TEST(Metrics, LumaIsClamped) {
  EXPECT_FLOAT_EQ(luma(test::flat(1, 1, 5, -3, nan))[0], 0.299f);
  EXPECT_FLOAT_EQ(luma(test::flat(1, 1, 1, 1, 1))[0], 1);
}

// 100 pixels, of which `count` differ by 0.25.
Verdict verdict_of(std::size_t count, const Thresholds& thresholds) {
  const Image a = test::flat(10, 10, 0.5f, 0.5f, 0.5f);
  Image b = a;
  for (std::size_t i = 0; i < count; i++) b.rgb[3 * i] = 0.75f;
  return compare(whole_picture(a), whole_picture(b), thresholds).verdict;
}

Thresholds limits(double fail, double fail_percent, double hard_fail, double warn, double warn_percent,
                  double hard_warn) {
  return {fail, fail_percent, hard_fail, warn, warn_percent, hard_warn};
}

TEST(Verdict, FollowsTheThresholds) {
  const double inf = infinity;
  EXPECT_EQ(verdict_of(0, {}), Verdict::same);
  EXPECT_EQ(verdict_of(1, {}), Verdict::failed);
  EXPECT_EQ(verdict_of(1, limits(0.25, 0, inf, 0.25, 0, inf)), Verdict::same);
  EXPECT_EQ(verdict_of(1, limits(0.25, 0, inf, 0.2, 0, inf)), Verdict::warning);
  EXPECT_EQ(verdict_of(2, limits(0.2, 2, inf, 1, 0, inf)), Verdict::same);
  EXPECT_EQ(verdict_of(3, limits(0.2, 2, inf, 1, 0, inf)), Verdict::failed);
  EXPECT_EQ(verdict_of(3, limits(1, 0, inf, 0.2, 3, inf)), Verdict::same);
  EXPECT_EQ(verdict_of(4, limits(1, 0, inf, 0.2, 3, inf)), Verdict::warning);
  EXPECT_EQ(verdict_of(1, limits(1, 100, 0.2, 1, 100, inf)), Verdict::failed);
  EXPECT_EQ(verdict_of(1, limits(1, 100, 0.25, 1, 100, 0.2)), Verdict::warning);
  EXPECT_EQ(verdict_of(1, limits(1, 100, 0.25, 1, 100, 0.25)), Verdict::same);
}

TEST(Verdict, ThresholdsAreFloatsAsTheValuesAre) {
  const ImageFile a = whole_picture(test::flat(1, 1, 0.0f, 0, 0)), b = whole_picture(test::flat(1, 1, 0.1f, 0, 0));
  EXPECT_EQ(compare(a, b, limits(0.1, 0, 0.1, 0.1, 0, 0.1)).verdict, Verdict::same);
}

TEST(Verdict, WhatIsNotFiniteFails) {
  const ImageFile a = whole_picture(test::flat(2, 2, 0.5f, 0, 0)), b = whole_picture(test::flat(2, 2, nan, 0, 0));
  EXPECT_EQ(compare(a, b, limits(1000, 0, infinity, 1000, 0, infinity)).verdict, Verdict::failed);
  EXPECT_EQ(compare(b, b, {}).verdict, Verdict::same);
}

TEST(Verdict, LayersCount) {
  const ImageFile a = test::crop_with_layers();
  EXPECT_EQ(compare(a, a, {}).verdict, Verdict::same);
  ImageFile b = a;
  b.layers[2].values[17] += 0.5f;
  const Comparison changed = compare(a, b, {});
  EXPECT_EQ(changed.verdict, Verdict::failed);
  EXPECT_EQ(changed.max_difference, 0);
  ASSERT_EQ(changed.layers.size(), 4u);
  EXPECT_EQ(changed.layers[2].pixels_beyond, 1u);
  EXPECT_NEAR(changed.layers[2].max_difference, 0.5, 1e-6);

  b = a;
  b.layers.pop_back();
  EXPECT_EQ(compare(a, b, {}).verdict, Verdict::failed);
  EXPECT_EQ(compare(b, a, {}).missing_layers, std::vector<std::string>{"samples"});
  b.layers.clear();
  EXPECT_EQ(compare(a, b, {}).verdict, Verdict::same);
}

TEST(Verdict, OnlyPicturesOfTheSameSizeAndPlaceCompare) {
  const ImageFile crop = test::crop_with_layers();
  ImageFile elsewhere = crop;
  elsewhere.window = {6, 7, 19, 16};
  EXPECT_TRUE(can_compare(crop, crop));
  EXPECT_FALSE(can_compare(crop, elsewhere));
  EXPECT_TRUE(can_compare(crop, whole_picture(crop.image)));  // the same crop as PNG, which stores no window
  EXPECT_FALSE(can_compare(crop, whole_picture(test::pattern(13, 10))));
  EXPECT_FALSE(can_compare(whole_picture(test::pattern(4, 3)), whole_picture(test::pattern(3, 4))));
}

}  // namespace
}  // namespace penumbra
