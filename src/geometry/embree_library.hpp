// Embree's functions, loaded when the first mesh needs them: a scene without one starts sooner. Here alone it shows
// whether it is Embree 3 or 4 (PENUMBRA_EMBREE).
#pragma once

#if PENUMBRA_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstdint>
#include <string>

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

// The name of its file, and what to say where that is missing.
std::string embree_file();
std::string embree_advice();

// What goes with the rays of a call to a filter function. Asks rtcIntersectN or rtcOccludedN: Embree 3 looks into the
// context to see whether the rays run together, Embree 4 into arguments of their own.
#if PENUMBRA_EMBREE == 4
using EmbreeContext = RTCRayQueryContext;

template <class Query, class Arguments>
[[gnu::always_inline]] inline void ask_embree(void (*function)(const int*, RTCScene, Query*, Arguments*),
                                              const std::uint32_t* valid, RTCScene scene, EmbreeContext& context,
                                              bool coherent, Query& query) {
  rtcInitRayQueryContext(&context);
  Arguments arguments{};
  arguments.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  arguments.feature_mask = RTC_FEATURE_FLAG_ALL;
  arguments.context = &context;
  function(reinterpret_cast<const int*>(valid), scene, &query, &arguments);
}
#else
using EmbreeContext = RTCIntersectContext;

template <class Query>
[[gnu::always_inline]] inline void ask_embree(void (*function)(const int*, RTCScene, EmbreeContext*, Query*),
                                              const std::uint32_t* valid, RTCScene scene, EmbreeContext& context,
                                              bool coherent, Query& query) {
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  function(reinterpret_cast<const int*>(valid), scene, &context, &query);
}
#endif

}  // namespace penumbra
