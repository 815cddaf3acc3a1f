#include "viewer/projection.hpp"

#include <gtest/gtest.h>

#include "rendering/render_text.hpp"

namespace penumbra {
namespace {

TEST(Projection, IsWhereTheEyeRaysGo) {
  const Frame frame = test::frame_from(
      test::scene_from("image_size 120 90\nfov 70\neye 1 2 3\nuvw 0.8 0 0.6 0 1 0 -0.6 0 0.8\nsphere 1 0 0 0\n"));
  const FrameCamera& camera = frame.camera;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {60.0, 45.0}, {119.5, 3.25}}) {
    float from[3], to[3];
    for (int i = 0; i < 3; i++) {
      const double direction = x * camera.per_x[i] + y * camera.per_y[i] + camera.corner[i];
      from[i] = static_cast<float>(camera.eye[i] + 2 * direction);
      to[i] = static_cast<float>(camera.eye[i] + 7 * direction);
    }
    const auto line = project_line(camera, from, to);
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->first.x, x, 1e-4);
    EXPECT_NEAR(line->first.y, y, 1e-4);
    EXPECT_NEAR(line->second.x, x, 1e-4);
    EXPECT_NEAR(line->second.y, y, 1e-4);
  }
}

TEST(Projection, CutsWhatIsBehindTheEye) {
  const Frame frame = test::frame_from(test::scene_from("image_size 100 100\nfov 90\nsphere 1 0 0 -5\n"));
  const auto line = project_line(frame.camera, {1, 0, -2}, {1, 0, 10});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->first.x, 75, 1e-4);
  EXPECT_GT(line->second.x, 1000) << "far to the right, and finite";
  EXPECT_TRUE(std::isfinite(line->second.x));
  EXPECT_FALSE(project_line(frame.camera, {1, 0, 1}, {0, 0, 10}));
}

}  // namespace
}  // namespace penumbra
