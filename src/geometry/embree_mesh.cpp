#include "geometry/embree_mesh.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "geometry/coincident_triangles.hpp"

namespace penumbra {
namespace {

void check(RTCDevice device) {
  const RTCError code = embree_library().rtcGetDeviceError(device);
  if (code == RTC_ERROR_NONE) return;
  throw std::runtime_error(code == RTC_ERROR_OUT_OF_MEMORY ? "not enough memory to build the triangle mesh"
                                                           : fmt::format("Embree failed with error {}", int(code)));
}

// Called for each triangle that is at most as far as the nearest so far: turns away one that is as far and named later.
void settle_tie(const RTCFilterFunctionNArguments* arguments) {
  auto* tie = reinterpret_cast<TieContext*>(arguments->context);
  const unsigned n = arguments->N;
  for (unsigned i = 0; i < n; i++) {
    if (arguments->valid[i] == 0) continue;
    const unsigned lane = RTCRayN_id(arguments->ray, n, i);
    const float distance = RTCRayN_tfar(arguments->ray, n, i);
    const MeshChunk& chunk = tie->mesh->chunks[RTCHitN_geomID(arguments->hit, n, i)];
    const std::uint32_t order = chunk.order + RTCHitN_primID(arguments->hit, n, i);
    if (distance == tie->distance[lane] && order > tie->order[lane]) {
      arguments->valid[i] = 0;
    } else {
      tie->distance[lane] = distance;
      tie->order[lane] = order;
    }
  }
}

}  // namespace

std::shared_ptr<RTCSceneTy> EmbreeDevice::build(const TriangleStore& store, std::span<const TriangleRange> ranges) {
  const EmbreeLibrary& embree = embree_library();
  if (!device_) {
    const std::string config = fmt::format("threads={}", threads_);
    device_.reset(embree.rtcNewDevice(config.c_str()), embree.rtcReleaseDevice);
    if (!device_) check(nullptr);
  }
  RTCDevice device = device_.get();
  std::shared_ptr<RTCSceneTy> scene(embree.rtcNewScene(device),
                                    [keep = device_, &embree](RTCScene s) { embree.rtcReleaseScene(s); });
  check(device);
  embree.rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  embree.rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_HIGH);
  const bool ties = any_coincide(store, ranges);
  for (std::size_t i = 0; i < ranges.size(); i++) {
    RTCGeometry geometry = embree.rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    embree.rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, store.vertices.data(), 0,
                                      12, store.vertices.size() / 3);
    embree.rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, store.indices.data(),
                                      std::size_t{ranges[i].first} * 12, 12, ranges[i].count);
    if (ties) embree.rtcSetGeometryIntersectFilterFunction(geometry, settle_tie);  // one takes time for every hit
    embree.rtcCommitGeometry(geometry);
    embree.rtcAttachGeometryByID(scene.get(), geometry, static_cast<unsigned>(i));
    embree.rtcReleaseGeometry(geometry);
  }
  embree.rtcCommitScene(scene.get());
  check(device);
  return scene;
}

}  // namespace penumbra
