// Compares a render of triangle meshes with Embree alone: renders a scene on one thread, and sends packets of rays
// through Embree without sampling and shading, each kind of ray with the context flag that is best for it. The packets
// are those that reach the meshes of a second scene: with the same scene, the work of Embree in the render; with a
// scene whose mesh also contains the other shapes, all rays. Embree's scenes have our flags and no filter. Prints the
// seconds of both and their ratio. Usage: mesh_replay RENDERED.cli REPLAYED.cli [RAYS] [TURNS]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/shared_library.hpp"
#include "geometry/embree_library.hpp"
#include "language/scene_file.hpp"
#include "rendering/isa.hpp"
#include "rendering/uniform_render.hpp"

namespace {

using namespace penumbra;

constexpr int lanes = 16;

// The arguments of one call of Embree, before the call.
struct Query {
  alignas(64) RTCRayHit16 rays;
  alignas(64) int valid[lanes];
  std::size_t mesh;
};

// The calls of one kind: of rtcIntersect16 or rtcOccluded16, with or without the flag for coherent rays.
struct Kind {
  const char* name;
  bool occluded;
  bool coherent;
  std::vector<Query> queries = {};
};

struct Recorder {
  const EmbreeLibrary* embree = nullptr;
  std::vector<RTCScene> scenes;
  Kind kinds[4] = {{"intersect, coherent", false, true},
                   {"intersect", false, false},
                   {"occluded, coherent", true, true},
                   {"occluded", true, false}};

  Query& add(const int* valid, RTCScene scene, const RTCIntersectContext* context, bool occluded) {
    const bool coherent = (context->flags & RTC_INTERSECT_CONTEXT_FLAG_COHERENT) != 0;
    Query& query = kinds[2 * occluded + !coherent].queries.emplace_back();
    std::memcpy(query.valid, valid, sizeof query.valid);
    query.mesh = static_cast<std::size_t>(std::find(scenes.begin(), scenes.end(), scene) - scenes.begin());
    return query;
  }
};
Recorder recorder;

void record_intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit16* rays) {
  recorder.add(valid, scene, context, false).rays = *rays;
  recorder.embree->rtcIntersect16(valid, scene, context, rays);
}
void record_occluded(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRay16* rays) {
  recorder.add(valid, scene, context, true).rays.ray = *rays;
  recorder.embree->rtcOccluded16(valid, scene, context, rays);
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Render {
  double seconds;
  RayCounts rays;
};

Render render(const Frame& frame, const Kernel& kernel, std::uint32_t rays) {
  Film film({0, 0, frame.settings.width, frame.settings.height}, {}, SampleCounts::uniform);
  RenderState state;
  const double start = now();
  const RayCounts counts = render_samples(film, frame, kernel, {film.crop(), {}, 1}, {0, rays}, state);
  return {now() - start, counts};
}

// The seconds that Embree takes for these queries. The packets are copied into the cache before the clock starts.
double replay(const EmbreeLibrary& embree, const std::vector<RTCScene>& scenes, const Kind& kind, bool coherent) {
  constexpr std::size_t part = 32;
  static Query scratch[part];
  double seconds = 0;
  for (std::size_t first = 0; first < kind.queries.size(); first += part) {
    const std::size_t count = std::min(part, kind.queries.size() - first);
    std::copy_n(kind.queries.begin() + static_cast<std::ptrdiff_t>(first), count, scratch);
    const double start = now();
    for (std::size_t i = 0; i < count; i++) {
      Query& query = scratch[i];
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
      if (kind.occluded) {
        embree.rtcOccluded16(query.valid, scenes[query.mesh], &context, &query.rays.ray);
      } else {
        embree.rtcIntersect16(query.valid, scenes[query.mesh], &context, &query.rays);
      }
    }
    seconds += now() - start;
  }
  return seconds;
}

std::vector<RTCScene> scenes_of(const Frame& frame) {
  std::vector<RTCScene> scenes;
  for (const Mesh& mesh : frame.world.meshes) scenes.push_back(mesh.scene.get());
  return scenes;
}

void remove_filters(const Frame& frame) {
  const SharedLibrary file(embree_file(), embree_advice());
  decltype(&rtcGetGeometry) get_geometry = nullptr;
  file.load("rtcGetGeometry", get_geometry);
  const EmbreeLibrary& embree = embree_library();
  for (const Mesh& mesh : frame.world.meshes) {
    for (unsigned id = 0; id < mesh.chunks.size(); id++) {
      RTCGeometry geometry = get_geometry(mesh.scene.get(), id);
      embree.rtcSetGeometryIntersectFilterFunction(geometry, nullptr);
      embree.rtcCommitGeometry(geometry);
    }
    embree.rtcCommitScene(mesh.scene.get());
  }
}

Frame frame_of(const char* path, std::uint32_t rays) {
  const SceneFile file = read_scene(path, {});
  for (const Diagnostic& diagnostic : file.diagnostics) fmt::print(stderr, "{}", to_string(diagnostic));
  if (file.actions.empty()) throw std::runtime_error("no picture in this scene");
  Scene scene = *std::get<Picture>(file.actions.front()).scene;
  scene.settings.rays_per_pixel = static_cast<int>(rays);
  Frame frame = make_frame(scene, 1);
  if (frame.world.meshes.empty()) throw std::runtime_error("no mesh in this scene that is large enough for Embree");
  return frame;
}

void record(const char* path, const Kernel& kernel, std::uint32_t rays) {
  Frame frame = frame_of(path, rays);
  EmbreeLibrary recording = embree_library();
  recording.rtcIntersect16 = record_intersect;
  recording.rtcOccluded16 = record_occluded;
  recorder.embree = &embree_library();
  recorder.scenes = scenes_of(frame);
  for (Mesh& mesh : frame.world.meshes) mesh.embree = &recording;
  render(frame, kernel, rays);
}

int run(const char* rendered_path, const char* replayed_path, std::uint32_t rays, int turns) {
  const Kernel* kernel = kernel_from_name(usable_kernels(), "avx512");
  if (kernel == nullptr) throw std::runtime_error("needs a machine with AVX-512 and a program built for it");
  record(replayed_path, *kernel, rays);
  const Frame frame = frame_of(rendered_path, rays);
  const Frame raw = frame_of(replayed_path, rays);
  remove_filters(raw);

  std::vector<double> ours, ratios;
  std::vector<double> best[4];
  RayCounts counts;
  for (int turn = 0; turn < turns; turn++) {
    const Render rendered = render(frame, *kernel, rays);
    ours.push_back(rendered.seconds);
    counts = rendered.rays;
    double embree = 0;
    for (int k = 0; k < 4; k++) {
      const Kind& kind = recorder.kinds[k];
      best[k].push_back(std::min(replay(embree_library(), scenes_of(raw), kind, false),
                                 replay(embree_library(), scenes_of(raw), kind, true)));
      embree += best[k].back();
    }
    ratios.push_back(rendered.seconds / embree);
  }
  fmt::print("{}: {} triangles, {} rays a pixel, {:.1f} Mrays; packets of {}\n\n", rendered_path,
             frame.world.counts.triangles, rays, static_cast<double>(counts.total()) * 1e-6, replayed_path);
  fmt::print("| what | packets | seconds |\n| --- | --: | --: |\n");
  for (int k = 0; k < 4; k++) {
    if (recorder.kinds[k].queries.empty()) continue;
    fmt::print("| Embree: {} | {} | {:.4f} |\n", recorder.kinds[k].name, recorder.kinds[k].queries.size(),
               median(best[k]));
  }
  fmt::print("| render | | {:.4f} |\n\nrender / Embree: {:.2f} (median of {} turns)\n\n", median(ours), median(ratios),
             turns);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: mesh_replay RENDERED.cli REPLAYED.cli [RAYS] [TURNS]\n");
    return 64;
  }
  try {
    return run(argv[1], argv[2], argc > 3 ? static_cast<std::uint32_t>(std::stoul(argv[3])) : 16,
               argc > 4 ? std::stoi(argv[4]) : 5);
  } catch (const std::exception& error) {
    fmt::print(stderr, "mesh_replay: {}\n", error.what());
    return 1;
  }
}
