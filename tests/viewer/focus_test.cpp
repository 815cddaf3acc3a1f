#include <gtest/gtest.h>

#include "rendering/render_text.hpp"
#include "viewer/projection.hpp"

namespace penumbra {
namespace {

const Kernel& kernel() { return *usable_kernels().back(); }

TEST(Focus, IsTheDistanceAlongTheView) {
  // A wall at z = -7, seen at an angle: the plane in focus is parallel to it.
  const Frame frame = test::frame_from(test::scene_from("image_size 100 100\nfov 90\nbox -50 -50 -8 50 50 -7\n"));
  EXPECT_NEAR(distance_at(frame, kernel(), 50, 50).value_or(0), 7, 1e-5);
  EXPECT_NEAR(distance_at(frame, kernel(), 3, 80).value_or(0), 7, 1e-5);
}

TEST(Focus, FollowsTheCamera) {
  const Frame frame =
      test::frame_from(test::scene_from("image_size 100 100\neye 10 0 0\nuvw 0 0 -1 0 1 0 1 0 0\nsphere 1 4 0 0\n"));
  EXPECT_NEAR(distance_at(frame, kernel(), 50, 50).value_or(0), 5, 1e-5);
}

TEST(Focus, NothingIsNowhere) {
  const Frame frame = test::frame_from(test::scene_from("sphere 1 0 0 -5\n"));
  EXPECT_FALSE(distance_at(frame, kernel(), 1, 1));
}

}  // namespace
}  // namespace penumbra
