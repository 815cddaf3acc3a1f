#include "viewer/picture_view.hpp"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

using Pixel = PictureView::Pixel;

PictureView view_of(int width, int height, const WindowArea& area = {0, 0, 1000, 700}) {
  PictureView view;
  view.set_area(area);
  view.set_picture_size(width, height);
  return view;
}

TEST(PictureView, FitsWithAWholeZoom) {
  EXPECT_EQ(view_of(300, 300).zoom_factor(), 2);
  EXPECT_EQ(view_of(20, 20).zoom_factor(), 4);
  EXPECT_EQ(view_of(1000, 700).zoom_factor(), 1);
  EXPECT_EQ(view_of(1001, 700).zoom_factor(), 0.5);
  const WindowArea picture = view_of(300, 300).picture();
  EXPECT_EQ(picture.x, 200);
  EXPECT_EQ(picture.y, 50);
  EXPECT_EQ(picture.width, 600);
}

TEST(PictureView, TellsThePixelUnderAPlace) {
  PictureView view = view_of(300, 300);
  EXPECT_EQ(view.pixel_at({200, 50}), (Pixel{0, 0}));
  EXPECT_EQ(view.pixel_at({201.9, 51.9}), (Pixel{0, 0}));
  EXPECT_EQ(view.pixel_at({799, 649}), (Pixel{299, 299}));
  EXPECT_FALSE(view.pixel_at({199, 50}));
  EXPECT_FALSE(view.pixel_at({800, 649}));
}

TEST(PictureView, ZoomKeepsWhatIsUnderTheCursor) {
  PictureView view = view_of(300, 200);
  const PlaceInWindow place{431, 280};
  const auto pixel = view.pixel_at(place);
  ASSERT_TRUE(pixel);
  for (const int steps : {1, 2, 3, -4, 2, 20}) {
    view.zoom(steps, place);
    const auto now = view.pixel_at(place);
    ASSERT_TRUE(now);
    EXPECT_LE(std::abs(now->x - pixel->x), 1) << view.zoom_factor();
    EXPECT_LE(std::abs(now->y - pixel->y), 1) << view.zoom_factor();
  }
  EXPECT_EQ(view.zoom_factor(), 64);
  view.zoom(-1000, place);
  EXPECT_EQ(view.zoom_factor(), 1.0 / 16);
}

TEST(PictureView, StaysWhereTheUserPutIt) {
  PictureView view = view_of(300, 300);
  view.set_area({0, 0, 640, 640});
  EXPECT_EQ(view.picture().x, 20) << "nobody moved it";
  view.pan(15, -5);
  view.set_area({0, 0, 1000, 1000});
  EXPECT_EQ(view.picture().x, 35);
  view.set_picture_size(100, 100);
  EXPECT_EQ(view.zoom_factor(), 4) << "another picture is fitted again";
}

TEST(PictureView, SurvivesAnEmptyArea) {
  PictureView view = view_of(300, 300, {0, 0, 1, 1});
  EXPECT_GT(view.zoom_factor(), 0);
  view = view_of(0, 0);
  EXPECT_FALSE(view.pixel_at({500, 350}));
}

}  // namespace
}  // namespace penumbra
