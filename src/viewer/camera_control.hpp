// Turning, moving and zooming the camera with the mouse: it takes hold of a point of the scene, and what it does is a
// function of the place of the camera at that time and of how far the mouse has gone since.
#pragma once

#include <optional>

#include "picture/picture_options.hpp"
#include "tracing/frame.hpp"
#include "tracing/kernel.hpp"
#include "viewer/projection.hpp"

namespace penumbra {

struct CameraPose {
  Vec3 eye;
  CameraAxes axes;

  bool operator==(const CameraPose&) const = default;
};

CameraPose pose_of(const Camera& camera);

// The same, in as few digits as a point at this distance from the eye needs to stay where it is in the picture.
CameraPose as_written(const CameraPose& pose, double distance);

// What the mouse holds.
struct CameraGrip {
  CameraPose pose;     // of the camera when it took hold
  Vec3 point;          // of the scene
  Vec3 per_x, per_y;   // how far apart pixels are there, in the world
  Vec3 vertical;       // the axis of the world that is up in the scene
  double degrees = 0;  // of a turn, for each pixel

  double distance() const { return length(point - pose.eye); }
};

// Takes hold of what is at `place` in a picture, or of a point in the air if there is nothing. `camera` is the present
// camera, `up` that of the scene as it was read.
CameraGrip grip_at(const Camera& camera, Vec3 up, const Frame& frame, const Kernel& kernel, PlaceInPicture place);

// The camera goes round the point, so that the scene seems to turn with the mouse; never over the top.
CameraPose turned(const CameraGrip& grip, double pixels_right, double pixels_down);
// The camera moves sideways, so that the point stays under the mouse.
CameraPose moved(const CameraGrip& grip, double pixels_right, double pixels_down);
// The camera goes toward the point, by a tenth of the distance for each step, or away from it.
CameraPose nearer(const CameraGrip& grip, double steps);

}  // namespace penumbra
