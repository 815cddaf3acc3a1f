#include "picture/examine.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/precision.hpp"
#include "geometry/view_warnings.hpp"
#include "picture/cost.hpp"
#include "picture/scene_traits.hpp"

namespace penumbra {
namespace {

constexpr std::size_t most_scenes = 16;  // of one file that are examined
// Above these, a render may take longer than anybody wants.
constexpr double many_rays = 1e6, many_objects = 1e9;

// Collects warnings, none twice.
class Warnings {
 public:
  explicit Warnings(std::vector<Diagnostic>& list) : list_(list) {}

  void add(const Place& place, std::string message) {
    const auto same = [&](const Diagnostic& d) { return d.message == message; };
    if (message.empty() || std::any_of(list_.begin(), list_.end(), same)) return;
    list_.push_back(warning_at(place, std::move(message)));
  }

 private:
  std::vector<Diagnostic>& list_;
};

// Effects that a single ray cannot show, unless that ray is asked for.
void warn_of_one_ray(const Picture& picture, const Scene& scene, const PictureOptions& options, Warnings& warnings) {
  const Settings& settings = scene.settings;
  if (settings.rays_per_pixel > 1 || picture.speaks_of(Topic::rays) || options.rays) return;
  const auto add = [&](bool there, Topic topic, std::string_view what) {
    if (!there) return;
    warnings.add(picture.place_of(topic),
                 fmt::format("{} with one ray per pixel is noise; --rays 64, or `rays_per_pixel 64`, shows it", what));
  };
  add(has_lens(scene), Topic::lens, "the blur of a lens");
  add(moves(scene), Topic::motion, "motion");
  add(has_area_light(scene) && settings.shadows && settings.shadow_rays == 1, Topic::area_light, "a soft shadow");
  add((is_glossy(scene) && settings.reflection_rays == 1) || (is_translucent(scene) && settings.transmission_rays == 1),
      Topic::gloss, "gloss or blurred transmission");
}

void warn_of_cost(const Scene& scene, const Place& place, Warnings& warnings) {
  if (const double rays = most_rays_of_eye_ray(scene); rays > many_rays) {
    warnings.add(place, fmt::format("one eye ray may send up to {:.2g} rays, to the depth of {}: a smaller max_depth "
                                    "makes them fewer",
                                    rays, scene.settings.max_depth));
  }
  if (const double objects = objects_behind_names(scene); objects > many_objects) {
    warnings.add(place, fmt::format("the names of the scene stand for {:.2g} objects: a ray that goes through many of "
                                    "them takes long",
                                    objects));
  }
}

void examine(const Picture& picture, const PictureOptions& options, const Place& whole_file, Warnings& warnings) {
  // The copy of a scene with a million objects takes a while.
  const bool as_it_is = options == PictureOptions{};
  const Scene changed = as_it_is ? Scene() : with_options(*picture.scene, options);
  const Scene& scene = as_it_is ? *picture.scene : changed;
  warn_of_one_ray(picture, scene, options, warnings);
  warn_of_cost(scene, whole_file, warnings);
  warnings.add(picture.place_of(Topic::camera), empty_view_warning(scene, moves(scene)));
  warnings.add(picture.place_of(Topic::camera), buried_eye_warning(scene));
}

}  // namespace

SceneFile read_and_examine(const std::filesystem::path& scene, const PictureOptions& options, const ReadOptions& read) {
  ReadOptions all = read;
  all.course = options.course;
  all.lenient = options.lenient;
  all.allow_paths = options.allow_paths;
  SceneFile file = read_scene(scene, all);
  Warnings warnings(file.diagnostics);
  const Scene* last = nullptr;
  Place whole_file;
  if (!file.files.empty()) whole_file.file = file.files.front();
  std::size_t count = 0;
  for (const Action& action : file.actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (picture == nullptr || picture->scene.get() == last || count == most_scenes) continue;
    last = picture->scene.get();
    count++;
    examine(*picture, options, whole_file, warnings);
  }
  if (last != nullptr) warnings.add(whole_file, precision_warning(*last));
  return file;
}

}  // namespace penumbra
