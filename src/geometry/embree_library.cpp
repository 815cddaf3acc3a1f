#include "geometry/embree_library.hpp"

#include "base/shared_library.hpp"

namespace penumbra {
namespace {

EmbreeLibrary load() {
  const SharedLibrary file("libembree3.so.3", "install the Debian package libembree3-3");
  EmbreeLibrary e;
#define PENUMBRA_LOAD(name) file.load(#name, e.name)
  PENUMBRA_LOAD(rtcNewDevice);
  PENUMBRA_LOAD(rtcReleaseDevice);
  PENUMBRA_LOAD(rtcGetDeviceError);
  PENUMBRA_LOAD(rtcNewScene);
  PENUMBRA_LOAD(rtcReleaseScene);
  PENUMBRA_LOAD(rtcSetSceneFlags);
  PENUMBRA_LOAD(rtcSetSceneBuildQuality);
  PENUMBRA_LOAD(rtcCommitScene);
  PENUMBRA_LOAD(rtcNewGeometry);
  PENUMBRA_LOAD(rtcReleaseGeometry);
  PENUMBRA_LOAD(rtcSetSharedGeometryBuffer);
  PENUMBRA_LOAD(rtcSetGeometryIntersectFilterFunction);
  PENUMBRA_LOAD(rtcCommitGeometry);
  PENUMBRA_LOAD(rtcAttachGeometryByID);
  PENUMBRA_LOAD(rtcIntersect4);
  PENUMBRA_LOAD(rtcIntersect8);
  PENUMBRA_LOAD(rtcIntersect16);
  PENUMBRA_LOAD(rtcOccluded4);
  PENUMBRA_LOAD(rtcOccluded8);
  PENUMBRA_LOAD(rtcOccluded16);
#undef PENUMBRA_LOAD
  return e;
}

}  // namespace

const EmbreeLibrary& embree_library() {
  static const EmbreeLibrary library = load();
  return library;
}

}  // namespace penumbra
