#include "picture/cost.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tracing/frame.hpp"

namespace penumbra {
namespace {

// What one hit may send on, if each lobe of a surface sends so many rays.
double most_rays_of_lobes(const Scene& scene, int of_reflection, int of_transmission) {
  double most = 0;
  for (const Surface& s : scene.surfaces) {
    const int reflected = s.reflection != 0 ? of_reflection : 0,
              transmitted = s.transmission != 0 ? of_transmission : 0;
    most = std::max(most, static_cast<double>(reflected) + transmitted);
  }
  return most;
}

// From this depth on, at most one ray of a hit goes on (tracing/branching.hpp).
int depth_of_lone_rays(const Scene& scene) {
  const int most = scene.settings.max_depth;
  if (!chooses_branches(scene)) return most;
  int deepest = 1;
  for (const Surface& s : scene.surfaces) {
    const double two = std::sqrt(std::abs(s.reflection * s.transmission));
    const double larger = std::max(std::abs(s.reflection), std::abs(s.transmission));
    double worth = larger;  // of the rays that hit at that depth
    int depth = 1;
    while (depth < most && worth * two >= least_worth_of_two) worth *= larger, depth++;
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

double objects_in(const Objects& objects, const std::vector<double>& of_definition) {
  double count = 0;
  for (const Object& object : objects) {
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      count += of_definition[instance->definition];
    } else if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape)) {
      count += objects_in((*group)->objects, of_definition);
    } else {
      count += 1;
    }
  }
  return count;
}

}  // namespace

double most_rays_of_eye_ray(const Scene& scene) {
  const Settings& settings = scene.settings;
  double shadow_of_eye = 0, shadow_deeper = 0;
  if (const int chosen = chosen_light_rays(scene); chosen > 0) {
    shadow_of_eye = shadow_deeper = settings.shadows ? chosen : 0;
  } else if (settings.shadows) {
    for (const Light& light : scene.lights) {
      shadow_of_eye += has_area(light) ? settings.shadow_rays : 1;
      shadow_deeper += 1;
    }
  }
  const double branches = most_rays_of_lobes(scene, 1, 1);
  double below = 0;  // what a ray of the second hit sends at most, itself included
  const int alone = depth_of_lone_rays(scene);
  for (int depth = settings.max_depth; depth > 0; depth--) {
    below = 1 + shadow_deeper + (depth < alone ? branches : std::min(branches, 1.0)) * below;
  }
  return 1 + shadow_of_eye + most_rays_of_lobes(scene, settings.reflection_rays, settings.transmission_rays) * below;
}

double objects_behind_names(const Scene& scene) {
  std::vector<double> of_definition;  // a definition names only those before it
  for (const Object& definition : scene.definitions) of_definition.push_back(objects_in({definition}, of_definition));
  return objects_in(scene.root.objects, of_definition);
}

}  // namespace penumbra
