// Every scene that is read without an error (fuzzed_scene.hpp) renders: 8 x 8 pixels with one ray each and all layers,
// in a second of processor time, to a film of finite numbers. Rays end early, and scenes whose names stand for very
// many objects are left out: what those cost is known, and a render of them can be stopped.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>

#include "fuzzed_scene.hpp"
#include "invariants.hpp"
#include "rendering/isa.hpp"
#include "rendering/uniform_render.hpp"

namespace {

using namespace penumbra;

constexpr double most_seconds = 1;
constexpr double most_objects = 10'000;  // when every name is replaced by what it stands for

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double count_objects(const Object& object, const std::vector<double>& definitions) {
  if (const auto* instance = std::get_if<Instance>(&object.shape)) return definitions[instance->definition];
  const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape);
  if (group == nullptr) return 1;
  double sum = 1;
  for (const Object& inner : (*group)->objects) sum += count_objects(inner, definitions);
  return sum;
}

double count_objects(const Scene& scene) {
  std::vector<double> definitions;
  for (const Object& object : scene.definitions) definitions.push_back(1 + count_objects(object, definitions));
  double sum = 0;
  for (const Object& object : scene.root.objects) sum += count_objects(object, definitions);
  return sum;
}

void render(Scene scene) {
  Settings& settings = scene.settings;
  settings.width = settings.height = 8;
  settings.rays_per_pixel = settings.reflection_rays = settings.transmission_rays = settings.shadow_rays = 1;
  settings.max_depth = std::min(settings.max_depth, 4);
  Plan plan;
  plan.crop = {0, 0, settings.width, settings.height};
  for (const LayerRow& row : layer_table) plan.layers.add(row.layer);

  const Frame frame = make_frame(scene, 1);
  UniformRender render(frame, *usable_kernels().back(), plan, 1, false);
  RenderState state;
  render.run(state);
  require(render.is_finished());
  for (const float value : render.take_film().color()) require(std::isfinite(value));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const SceneFile file = read_fuzzed_scene(data, size);
  const double start = seconds();
  const Scene* last = nullptr;
  for (const Action& action : file.actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (picture == nullptr || picture->scene.get() == last) continue;
    if (last != nullptr && seconds() - start > most_seconds / 2) break;  // many pictures are no single slow one
    last = picture->scene.get();
    if (count_objects(*last) > most_objects) continue;
    const double before = seconds();
    render(*last);
    if (seconds() - before > most_seconds) {
      std::fprintf(stderr, "a picture took %g s of processor time\n", seconds() - before);
      std::abort();
    }
  }
  return 0;
}
