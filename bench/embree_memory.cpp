// How much memory Embree takes for the triangles of a scene by its own account: the peak while it builds, with our
// flags, from existing arrays. Prints triangles and bytes. Usage: embree_memory SCENE.cli [THREADS]
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>

#include "base/shared_library.hpp"
#include "geometry/embree_library.hpp"
#include "language/scene_file.hpp"

namespace {

using namespace penumbra;

struct Account {
  std::atomic<std::int64_t> now{0}, most{0};

  static bool note(void* account, ssize_t bytes, bool /*after*/) {
    auto& self = *static_cast<Account*>(account);
    const std::int64_t now = self.now += bytes;
    for (std::int64_t most = self.most; now > most && !self.most.compare_exchange_weak(most, now);) continue;
    return true;
  }
};

int run(const char* path, const char* threads) {
  const SceneFile file = read_scene(path, {});
  if (file.actions.empty()) throw std::runtime_error("no picture in this scene");
  const TriangleStore& store = *std::get<Picture>(file.actions.front()).scene->triangles;
  const EmbreeLibrary& embree = embree_library();
  const SharedLibrary library(embree_file(), embree_advice());
  decltype(&rtcSetDeviceMemoryMonitorFunction) set_monitor = nullptr;
  library.load("rtcSetDeviceMemoryMonitorFunction", set_monitor);

  Account account;
  RTCDevice device = embree.rtcNewDevice(fmt::format("threads={}", threads).c_str());
  set_monitor(device, Account::note, &account);
  RTCScene scene = embree.rtcNewScene(device);
  embree.rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  embree.rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = embree.rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  embree.rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, store.vertices.data(), 0,
                                    12, store.vertices.size() / 3);
  embree.rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, store.indices.data(), 0, 12,
                                    store.triangle_count());
  embree.rtcCommitGeometry(geometry);
  embree.rtcAttachGeometryByID(scene, geometry, 0);
  embree.rtcReleaseGeometry(geometry);
  embree.rtcCommitScene(scene);
  fmt::print("{} {}\n", store.triangle_count(), account.most.load());
  embree.rtcReleaseScene(scene);
  embree.rtcReleaseDevice(device);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: embree_memory SCENE.cli [THREADS]\n");
    return 64;
  }
  try {
    return run(argv[1], argc > 2 ? argv[2] : "1");
  } catch (const std::exception& error) {
    fmt::print(stderr, "embree_memory: {}\n", error.what());
    return 1;
  }
}
