// Embree's functions, loaded when the first mesh needs them: a scene without one starts sooner.
#pragma once

#include <embree3/rtcore.h>

namespace penumbra {

struct EmbreeLibrary {
  decltype(&::rtcNewDevice) rtcNewDevice;
  decltype(&::rtcReleaseDevice) rtcReleaseDevice;
  decltype(&::rtcGetDeviceError) rtcGetDeviceError;
  decltype(&::rtcNewScene) rtcNewScene;
  decltype(&::rtcReleaseScene) rtcReleaseScene;
  decltype(&::rtcSetSceneFlags) rtcSetSceneFlags;
  decltype(&::rtcSetSceneBuildQuality) rtcSetSceneBuildQuality;
  decltype(&::rtcCommitScene) rtcCommitScene;
  decltype(&::rtcNewGeometry) rtcNewGeometry;
  decltype(&::rtcReleaseGeometry) rtcReleaseGeometry;
  decltype(&::rtcSetSharedGeometryBuffer) rtcSetSharedGeometryBuffer;
  decltype(&::rtcSetGeometryIntersectFilterFunction) rtcSetGeometryIntersectFilterFunction;
  decltype(&::rtcCommitGeometry) rtcCommitGeometry;
  decltype(&::rtcAttachGeometryByID) rtcAttachGeometryByID;
  decltype(&::rtcIntersect4) rtcIntersect4;
  decltype(&::rtcIntersect8) rtcIntersect8;
  decltype(&::rtcIntersect16) rtcIntersect16;
  decltype(&::rtcOccluded4) rtcOccluded4;
  decltype(&::rtcOccluded8) rtcOccluded8;
  decltype(&::rtcOccluded16) rtcOccluded16;
};

// The library, which stays loaded. Throws std::runtime_error where it is not installed.
const EmbreeLibrary& embree_library();

}  // namespace penumbra
