#include "app/check/check_command.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "app/check/lens_table.hpp"
#include "app/options/shared_options.hpp"
#include "app/render/outputs.hpp"
#include "app/render/render_paths.hpp"
#include "base/say.hpp"
#include "picture/examine.hpp"

namespace penumbra {
namespace {

// Counts of what the groups and definitions of a scene hold, each counted once however often it is placed.
struct Counts {
  struct Kind {
    std::uint64_t count = 0;
    KindName name;
  };
  std::array<Kind, std::variant_size_v<Shape>> kinds;  // in the order of Shape
  std::uint64_t moving = 0;
};

void count_objects(const Objects& objects, Counts& counts) {
  for (const Object& object : objects) {
    const auto* triangles = std::get_if<TriangleRange>(&object.shape);
    Counts::Kind& kind = counts.kinds[object.shape.index()];
    kind.count += triangles != nullptr ? triangles->count : 1;
    kind.name = name_of(object.shape);
    if (object.motion != Vec3{}) counts.moving++;
    if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.shape)) {
      count_objects((*group)->objects, counts);
    }
  }
}

std::string plural(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

// The parts, separated by commas; "none" if there are none.
std::string listed(const std::vector<std::string>& parts) {
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

void add_count(std::vector<std::string>& parts, std::uint64_t count, std::string_view one, std::string_view many) {
  if (count > 0) parts.push_back(plural(count, one, many));
}

std::string triple(Vec3 v) { return fmt::format("{:g} {:g} {:g}", v.x + 0.0, v.y + 0.0, v.z + 0.0); }

std::string describe_lights(const Scene& scene) {
  std::array<std::uint64_t, std::variant_size_v<Light>> counts{};
  std::array<std::string_view, std::variant_size_v<Light>> names;
  for (const Light& light : scene.lights) {
    counts[light.index()]++;
    names[light.index()] = std::visit([](const auto& l) { return l.name; }, light);
  }
  std::vector<std::string> parts;
  for (std::size_t kind = 0; kind < counts.size(); kind++) {
    add_count(parts, counts[kind], names[kind], fmt::format("{}s", names[kind]));
  }
  return listed(parts);
}

std::string describe_camera(const Camera& camera) {
  std::string text = fmt::format("eye {}, looking along {}, fov {:g}", triple(camera.eye),
                                 triple(-normalize(camera.back)), camera.fov_degrees);
  text += camera.lens_radius > 0
              ? fmt::format(", lens of radius {:g} focused at {:g}", camera.lens_radius, camera.focus_distance)
              : ", pinhole";
  return text + fmt::format(", shutter {:g} to {:g}", camera.shutter_open, camera.shutter_close);
}

std::string describe_objects(const Scene& scene, const Counts& counts) {
  std::vector<std::string> parts;
  for (const Counts::Kind& kind : counts.kinds) {
    // Named objects come before their instances, which are the last kind.
    if (&kind == &counts.kinds.back()) {
      add_count(parts, scene.definitions.size(), "named object", "named objects");
    }
    add_count(parts, kind.count, kind.name.one, kind.name.several);
  }
  add_count(parts, counts.moving, "moving object", "moving objects");
  return listed(parts);
}

std::string describe_picture(const Picture& picture, std::size_t number) {
  const Scene& scene = *picture.scene;
  Counts counts;
  count_objects(scene.root.objects, counts);
  count_objects(scene.definitions, counts);
  std::string text =
      fmt::format("picture {}: {}\n", number, picture.file.empty() ? "named after the scene" : picture.file);
  const auto row = [&](std::string_view name, const std::string& value) {
    text += fmt::format("  {:<10} {}\n", name, value);
  };
  row("size", fmt::format("{} x {}", scene.settings.width, scene.settings.height));
  row("rays", fmt::format("{} per pixel, depth {}, sampler {}, seed {}", scene.settings.rays_per_pixel,
                          scene.settings.max_depth, pattern_names[static_cast<int>(scene.settings.pattern)],
                          scene.settings.seed));
  if (std::max({scene.settings.reflection_rays, scene.settings.transmission_rays, scene.settings.shadow_rays}) > 1) {
    row("first hits", fmt::format("{} reflection, {} transmission and {} shadow rays", scene.settings.reflection_rays,
                                  scene.settings.transmission_rays, scene.settings.shadow_rays));
  }
  row("camera", describe_camera(scene.camera));
  row("background", triple(scene.background));
  row("lights", describe_lights(scene));
  row("objects", describe_objects(scene, counts));
  row("surfaces", fmt::format("{}", scene.surfaces.size()));
  if (!picture.rects.empty()) row("painted", plural(picture.rects.size(), "rectangle", "rectangles"));
  return text + lens_table(scene);
}

// Throws FileError 64 if a picture of the scene would replace another one, or a file that the scene reads.
void require_own_files(const std::string& scene, const SceneFile& file) {
  PathTable table;
  add_inputs(table, scene, file);
  for (const auto& of_picture : output_files(file.actions, scene, {})) {
    for (const std::filesystem::path& path : of_picture) table.writes(path, "a picture of the scene");
  }
}

}  // namespace

std::string describe(const SceneFile& file) {
  std::string text;
  for (const std::string& name : file.files) text += fmt::format("read: {}\n", name);
  std::size_t number = 0;
  const Scene* last = nullptr;
  for (const Action& action : file.actions) {
    const Picture* const picture = std::get_if<Picture>(&action);
    if (picture == nullptr) continue;
    number++;
    if (picture->scene.get() == last && picture->rects.empty()) {
      text += fmt::format("picture {}: {}, the same scene\n", number,
                          picture->file.empty() ? "named after the scene" : picture->file);
    } else {
      text += describe_picture(*picture, number);
    }
    last = picture->scene.get();
  }
  const auto warnings = std::count_if(file.diagnostics.begin(), file.diagnostics.end(),
                                      [](const Diagnostic& d) { return d.severity == Severity::warning; });
  text += plural(static_cast<std::uint64_t>(warnings), "warning", "warnings") + '\n';
  return text;
}

Subcommand check_subcommand(CheckOptions& options) {
  Subcommand check{"check", "Read a scene and describe it, or report its errors", {}, {}, {}, {}, {}, {}};
  check.options = {
      {"SCENE", "FILE", "The scene file (.cli); - for standard input", into(options.scene), Times::once, true},
      picture_option(options.picture, "course"),
      picture_option(options.picture, "lenient"),
      paths_option(options.picture)};
  check.run = [&options] { return check_command(options); };
  return check;
}

int check_command(const CheckOptions& options) {
  const SceneFile file = read_and_examine(options.scene, options.picture);
  for (const Diagnostic& diagnostic : file.diagnostics) say(to_string(diagnostic));
  if (!file.found) return EX_NOINPUT;
  if (has_error(file.diagnostics)) return EX_DATAERR;
  require_own_files(options.scene, file);
  print(describe(file));
  return 0;
}

}  // namespace penumbra
