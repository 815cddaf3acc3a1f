#include "geometry/embree_library.hpp"

#include <fmt/format.h>

#include "base/shared_library.hpp"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>

namespace {
bool is_loaded = false;
}

// LeakSanitizer asks this at the end. It falls over the threads that Embree keeps, if one begins or ends meanwhile.
extern "C" int __lsan_is_turned_off() { return is_loaded; }
#endif

namespace penumbra {
namespace {

EmbreeLibrary load() {
#ifdef __SANITIZE_ADDRESS__
  is_loaded = true;
#endif
  const SharedLibrary file(embree_file(), embree_advice());
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

std::string embree_file() { return fmt::format("libembree{0}.so.{0}", PENUMBRA_EMBREE); }
std::string embree_advice() { return fmt::format("install the Debian package libembree{0}-{0}", PENUMBRA_EMBREE); }

const EmbreeLibrary& embree_library() {
  static const EmbreeLibrary library = load();
  return library;
}

}  // namespace penumbra
