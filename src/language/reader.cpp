// Opens and reads the files of a scene, and finally reports what is missing or odd.
#include <algorithm>
#include <span>
#include <utility>

#include "language/near_word.hpp"
#include "language/path_boundary.hpp"
#include "language/reading.hpp"
#include "language/scene_file.hpp"

namespace penumbra {
namespace {

SourcePlace whole_file(std::uint32_t visit) {
  SourcePlace place;
  place.visit = visit;
  return place;
}

// Enforces the limits on all files together.
Problem count_file(Reading& reading, std::size_t size) {
  reading.reads++;
  reading.bytes += size;
  if (reading.reads > reading.limits.reads)
    return fmt::format("the scene opens more than {} files", reading.limits.reads);
  if (reading.bytes > reading.limits.bytes)
    return fmt::format("the files of the scene have more than {} bytes", reading.limits.bytes);
  return {};
}

void remember_file(Reading& reading, const std::filesystem::path& path) {
  std::string name = path.string();
  if (std::find(reading.files.begin(), reading.files.end(), name) == reading.files.end()) {
    reading.files.push_back(std::move(name));
  }
}

void read_first_file(Reading& reading, const std::filesystem::path& path, LoadedFile file) {
  const std::uint32_t visit = reading.diagnostics.open(path.string(), {}, file.is_secret);
  remember_file(reading, path);
  if (const Problem wrong = count_file(reading, file.bytes.view().size()); !wrong.empty()) {
    return reading.diagnostics.error(whole_file(visit), wrong);
  }
  reading.open_files.push_back({path, file.identity, visit});
  interpret_text(reading, file.bytes, visit);
  if (file.bytes.has_shrunk()) reading.diagnostics.error(whole_file(visit), file_has_shrunk);
  if (!reading.diagnostics.is_full()) finish_reading(reading);
}

void report_open_ends(Reading& reading) {
  const SceneBuilder& builder = reading.builder;
  if (builder.in_polygon()) {
    reading.error(builder.polygon_place(), "this polygon is left open: there is no `end` after it");
  }
  for (int level = builder.tree().open_groups(); level > 0; level--) {
    const OpenGroup& group = builder.tree().group(level);
    reading.error(group.place, "this group is left open: there is no `{}` for it",
                  group.opener == "begin_list" ? "end_list` or `end_accel" : "end_accel");
  }
  for (const auto& [matrix, place] : builder.pushed()) {
    reading.diagnostics.warning(place, "this `push` is left open: there is no `pop` for it");
  }
}

void report_unused(Reading& reading) {
  for (const auto& [name, named] : reading.builder.tree().names) {
    if (named.used) continue;
    reading.diagnostics.warning(named.place,
                                fmt::format("{} is never used: there is no `instance` of it", in_quotes(name)));
  }
  if (reading.after_pictures) {
    reading.diagnostics.warning(*reading.after_pictures,
                                "nothing from here on is in any picture: the last one is taken "
                                "before this line");
  }
}

// One sign alone is just an odd scene; two kinds of signs point to the other order.
void report_order_of_2018(Reading& reading) {
  const OrderOf2018& order = reading.order_of_2018;
  if (reading.course == Course::year_2018 || order.signs() < 2 || !order.first_sphere) return;
  reading.diagnostics.warning(*order.first_sphere,
                              "lights, surfaces and spheres look as if they were written in the order of 2018 "
                              "(`light r g b x y z`, `surface` with ambient first, `sphere x y z radius`)",
                              std::string(how_to_read_2018));
}

std::vector<CommandPlace> places_of(const Reading& reading, const std::vector<MadeBy>& makers) {
  std::vector<CommandPlace> places;
  places.reserve(makers.size());
  for (const MadeBy& by : makers) {
    const std::string file = by.visit == 0 ? std::string() : reading.diagnostics.file_of(by.visit);
    places.push_back({by.command, by.line, file});
  }
  return places;
}

// Offers the file whose name is near, by a path like the one that was given.
std::string offer_near(const std::filesystem::path& given, const std::string& near) {
  return near.empty() ? std::string() : did_you_mean((given.parent_path() / near).string());
}

}  // namespace

void set_course(Reading& reading, Course course) {
  reading.course = course;
  reading.highlight = year_of(course).highlight;
  Settings& settings = reading.builder.change().settings;
  settings.course = course;
  settings.max_depth = year_of(course).max_depth;
  settings.pattern = Pattern::random;
}

std::optional<NamedFile> open_named_file(Reading& reading, const Call& call) {
  const std::filesystem::path name(call.name(0));
  NamedFile file;
  file.path = name.is_absolute() ? name : reading.open_files.back().path.parent_path() / name;
  remember_file(reading, file.path);
  file.loaded = reading.load(file.path);
  if (!file.loaded.problem.empty()) {
    reading.diagnostics.error(call.place_of_argument(0),
                              fmt::format("cannot read `{}`: {}", file.path.string(), file.loaded.problem),
                              offer_near(name, file.loaded.near));
    return std::nullopt;
  }
  if (const Problem wrong = count_file(reading, file.loaded.bytes.view().size()); !wrong.empty()) {
    reading.diagnostics.error(call.place(), wrong);
    return std::nullopt;
  }
  return file;
}

void finish_reading(Reading& reading) {
  report_open_ends(reading);
  if (reading.diagnostics.has_error()) return;
  report_unused(reading);
  report_order_of_2018(reading);
  if (reading.builder.pictures() > 0) return;
  take_picture(reading, {}, whole_file(0));
}

void take_picture(Reading& reading, std::string file, const SourcePlace& place) {
  TopicPlaces places;
  for (std::size_t i = 0; i < places.size(); i++) {
    if (reading.topics[i]) places[i] = reading.diagnostics.known(*reading.topics[i]);
  }
  places[static_cast<std::size_t>(Topic::picture)] = reading.diagnostics.known(place);
  if (const Problem wrong = reading.builder.add_picture(std::move(file), std::move(places)); !wrong.empty()) {
    reading.diagnostics.error(place, wrong);
  }
  if (reading.diagnostics.has_error()) return;  // what is missing may be what has the error
  const Picture& picture = reading.builder.last_picture();
  const bool has_objects = reading.builder.tree().objects_to_copy() > 0;
  if (!has_objects && picture.rects.empty()) reading.diagnostics.warning(place, "there is no object in this picture");
  if (has_objects && reading.builder.scene().lights.empty()) {
    reading.diagnostics.warning(place, "there is no light in this picture");
  }
}

SceneFile read_scene_with(const std::filesystem::path& path, std::optional<std::string> text,
                          const ReadOptions& options, FileLoader load, const Limits& limits) {
  Reading reading(options, std::move(load), limits);
  if (options.course != Course::off) set_course(reading, options.course);
  SceneFile result;
  LoadedFile file = reading.load(path);
  if (text) {
    file.bytes = FileBytes(std::move(*text));
    file.problem.clear();
  }
  if (file.problem.empty()) {
    read_first_file(reading, path, std::move(file));
  } else {
    result.found = false;
    reading.diagnostics.error(whole_file(reading.diagnostics.open(path.string(), {})),
                              "cannot read this file: " + file.problem, offer_near(path, file.near));
  }
  if (!reading.diagnostics.has_error()) {
    result.lights = places_of(reading, reading.builder.light_makers());
    result.surfaces = places_of(reading, reading.builder.surface_makers());
    result.actions = reading.builder.take_actions();
  }
  result.diagnostics = reading.diagnostics.take();
  result.files = std::move(reading.files);
  result.varies = reading.varies;
  return result;
}

SceneFile read_scene(const std::filesystem::path& path, const ReadOptions& options) {
  const auto load_file = options.edited ? load_copy_from_disk : load_from_disk;
  const bool is_pipe = path == standard_input;
  ContentHasher hasher;
  std::vector<ReadContent> contents;
  const auto load = [&, is_first = true](const std::filesystem::path& file) mutable {
    const bool is_scene = std::exchange(is_first, false);
    if (!is_scene && !options.allow_paths && !is_beside_scene(file, is_pipe ? "stdin" : path)) {
      LoadedFile refused;
      refused.problem = "it is outside the folder of the scene; --allow-paths allows that";
      return refused;
    }
    LoadedFile loaded = is_scene && is_pipe ? load_standard_input() : load_file(file);
    if (options.hash) {
      const auto bytes = std::as_bytes(std::span(loaded.bytes.view()));
      hasher.add(bytes);
      ContentHasher of_file;
      of_file.add(bytes);
      contents.push_back({file.string(), of_file.value(), loaded.problem});
    }
    return loaded;
  };
  SceneFile result = read_scene_with(is_pipe ? "<stdin>" : path, std::nullopt, options, load);
  if (options.hash) result.hash = hasher.value();
  result.contents = std::move(contents);
  return result;
}

SceneFile read_scene_text(std::string text, const std::filesystem::path& path, const ReadOptions& options) {
  return read_scene_with(path, std::move(text), options, load_from_disk);
}

}  // namespace penumbra
