// From a film to a picture: where rectangles are painted, and which number of a layer becomes which channel.
#include "picture/develop.hpp"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

// A film of one sample in each pixel of the crop, whose numbers all are that of their place among a pixel's sums.
Film film_of(const PixelRect& crop, const Layers& layers) {
  Film film(crop, layers);
  for_pixels(crop, [&](int x, int y) {
    const Pixel pixel{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)};
    film.set_samples({&pixel, 1}, 1);
    const FilmView view = film.view();
    for (const FilmPlane& plane : view.all()) {
      for (int i = 0; i < plane.sums_per_pixel; i++) plane.of_pixel(crop.index_of(x, y))[i] = i + 1;
    }
  });
  return film;
}

// A rectangle is counted from the bottom left of the whole picture, a crop from its top left.
TEST(Develop, RectanglesAreCountedFromTheBottomOfTheWholePicture) {
  const PixelRect crop{1, 1, 6, 5};
  Development development;
  development.full_width = 8;
  development.full_height = 6;
  development.rects = {{2, 1, 4, 3, {9, 8, 7}}};
  const ImageFile file = develop(film_of(crop, {}), development);
  for_pixels(crop, [&](int x, int y) {
    const bool painted = x >= 2 && x < 4 && y >= 3 && y < 5;
    const float* pixel = &file.image.rgb[3 * crop.index_of(x, y)];
    EXPECT_EQ(pixel[0], painted ? 9 : 1) << x << ", " << y;
    EXPECT_EQ(pixel[2], painted ? 7 : 3) << x << ", " << y;
  });
}

TEST(Develop, ChannelsAreNamedInTheOrderOfTheirNumbers) {
  Development development;
  development.full_width = 2;
  development.full_height = 1;
  const ImageFile file = develop(film_of({0, 0, 2, 1}, {Layer::normal, Layer::albedo}), development);
  ASSERT_EQ(file.layers.size(), 6u);
  const std::pair<const char*, float> expected[] = {{"normal.X", 1.0f}, {"normal.Y", 2.0f}, {"normal.Z", 3.0f},
                                                    {"albedo.R", 1.0f}, {"albedo.G", 2.0f}, {"albedo.B", 3.0f}};
  for (std::size_t i = 0; i < 6; i++) {
    EXPECT_EQ(file.layers[i].name, expected[i].first);
    EXPECT_EQ(file.layers[i].values[1], expected[i].second) << file.layers[i].name;
  }
}

}  // namespace
}  // namespace penumbra
