#include "viewer/camera_control.hpp"

#include <gtest/gtest.h>

#include "rendering/render_text.hpp"

namespace penumbra {
namespace {

const std::string scene_text =
    "image_size 120 90\nfov 50\neye 1 2 6\nuvw 0.8 0 0.6  0 1 0  -0.6 0 0.8\nlight 0 9 0 1 1 1\nsphere 3 5 2 -1\n";

class CameraControl : public testing::Test {
 protected:
  CameraGrip grip_at_place(PlaceInPicture place) const {
    return grip_at(scene_.camera, scene_.camera.up, frame_, *usable_kernels().back(), place);
  }
  // Where a camera sees the point that is held.
  PlaceInPicture seen(const CameraPose& pose, Vec3 point) const {
    Scene scene = scene_;
    scene.camera.eye = pose.eye;
    scene.camera.right = pose.axes.right;
    scene.camera.up = pose.axes.up;
    scene.camera.back = pose.axes.back;
    const Frame frame = test::frame_from(scene);
    float at[3];
    set3(at, point);
    const auto line = project_line(frame.camera, at, at);
    EXPECT_TRUE(line);
    return line ? line->first : PlaceInPicture();
  }

  Scene scene_ = test::scene_from(scene_text);
  Frame frame_ = test::frame_from(scene_);
};

TEST_F(CameraControl, HoldsWhatIsAtThePlace) {
  const CameraGrip grip = grip_at_place({70, 40});
  EXPECT_NEAR(length(grip.point - Vec3{5, 2, -1}), 3, 1e-4) << "a point of the sphere";
  const PlaceInPicture place = seen(grip.pose, grip.point);
  EXPECT_NEAR(place.x, 70, 1e-3);
  EXPECT_NEAR(place.y, 40, 1e-3);
}

TEST_F(CameraControl, MovesWithTheMouse) {
  for (const PlaceInPicture from : {PlaceInPicture{70, 40}, PlaceInPicture{3, 5}}) {
    const CameraGrip grip = grip_at_place(from);
    const PlaceInPicture place = seen(moved(grip, 12, -7), grip.point);
    EXPECT_NEAR(place.x, from.x + 12, 1e-3);
    EXPECT_NEAR(place.y, from.y - 7, 1e-3);
  }
}

TEST_F(CameraControl, ComesNearerToWhatIsHeld) {
  const CameraGrip grip = grip_at_place({70, 40});
  const CameraPose pose = nearer(grip, 2);
  EXPECT_NEAR(length(pose.eye - grip.point), 0.81 * grip.distance(), 1e-9);
  const PlaceInPicture place = seen(pose, grip.point);
  EXPECT_NEAR(place.x, 70, 1e-3);
  EXPECT_NEAR(place.y, 40, 1e-3);
  EXPECT_NEAR(length(nearer(grip, -1).eye - grip.point), grip.distance() / 0.9, 1e-9);
}

TEST_F(CameraControl, TurnsRoundWhatIsHeldButNotOverTheTop) {
  const CameraGrip grip = grip_at_place({70, 40});
  for (const double down : {-1000.0, 0.0, 15.0, 1000.0}) {
    const CameraPose pose = turned(grip, 30, down);
    EXPECT_NEAR(length(pose.eye - grip.point), grip.distance(), 1e-9);
    EXPECT_GT(pose.axes.up.y, 0.05);
    EXPECT_NEAR(dot(pose.axes.right, pose.axes.back), 0, 1e-9);
    EXPECT_NEAR(pose.axes.right.y, 0, 1e-9) << "the horizon stays level";
    const PlaceInPicture place = seen(pose, grip.point);
    EXPECT_NEAR(place.x, 70, 1e-2);
    EXPECT_NEAR(place.y, 40, 1e-2);
  }
}

TEST_F(CameraControl, IsWrittenInFewDigits) {
  const CameraGrip grip = grip_at_place({70, 40});
  const CameraPose exact = turned(grip, 13, 7);
  const CameraPose pose = as_written(exact, grip.distance());
  EXPECT_EQ(pose, as_written(pose, grip.distance()));
  EXPECT_EQ(pose.eye.x, std::round(pose.eye.x * 1e4) / 1e4);
  const PlaceInPicture place = seen(pose, grip.point);
  EXPECT_NEAR(place.x, 70, 0.05);
  EXPECT_NEAR(place.y, 40, 0.05);
}

}  // namespace
}  // namespace penumbra
