// The commands for pictures, files and timers, and the painted rectangles of the 2-D test commands.
#include <algorithm>
#include <filesystem>

#include "language/actions.hpp"
#include "language/path_boundary.hpp"

namespace penumbra::actions {
namespace {

void take_picture_here(Reading& reading, const Call& call, std::string_view file) {
  take_picture(reading, std::string(file), call.place());
  reading.objects_in_pictures = reading.builder.tree().objects_added();
  reading.after_pictures.reset();
}

bool has_ending(std::string_view name, std::string_view ending) {
  return name.size() > ending.size() &&
         std::ranges::equal(name.substr(name.size() - ending.size()), ending, {},
                            [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
}

}  // namespace

void background(Reading& reading, const Call& call) { reading.builder.change().background = call.vec(0); }

void image_size(Reading& reading, const Call& call) {
  if (call[0] * call[1] > most_pixels) {
    return reading.error(call.place_of_argument(0),
                         "a picture of {} x {} pixels is too large; at most {} pixels are allowed", call.whole(0),
                         call.whole(1), most_pixels);
  }
  Scene& scene = reading.builder.change();
  scene.settings.width = call.whole(0);
  scene.settings.height = call.whole(1);
}

void write(Reading& reading, const Call& call) {
  const std::string name(call.name(0));
  if (!has_ending(name, ".png") && !has_ending(name, ".exr")) {
    const std::string message =
        fmt::format("the name of a picture has to end in .png or .exr; found {}", in_quotes(name));
    if (!reading.options.lenient) return reading.diagnostics.error(call.place_of_argument(0), message);
    reading.diagnostics.warning(call.place_of_argument(0), message);
  }
  if (!reading.options.allow_paths && !is_in_reach(name, reading.open_files.front().path)) {
    return reading.error(call.place_of_argument(0),
                         "cannot write {}: it is outside the working folder and the folder of the scene; --allow-paths "
                         "allows that",
                         in_quotes(name));
  }
  const std::string normal = std::filesystem::path(name).lexically_normal().string();
  const auto [first, is_new] = reading.written.try_emplace(normal, call.place());
  if (!is_new) {
    return reading.error(call.place_of_argument(0), "{} is written at {}:{} already, and this picture would replace it",
                         in_quotes(name), reading.diagnostics.file_of(first->second), first->second.line);
  }
  take_picture_here(reading, call, name);
}

void render(Reading& reading, const Call& call) { take_picture_here(reading, call, {}); }

void read(Reading& reading, const Call& call) {
  if (reading.open_files.size() >= reading.limits.open_files) {
    return reading.error(call.place(), "files read each other more than {} deep", reading.limits.open_files);
  }
  std::optional<NamedFile> file = open_named_file(reading, call);
  if (!file) return;
  const auto same = [&](const OpenFile& open) { return open.identity == file->loaded.identity; };
  const auto found = std::find_if(reading.open_files.begin(), reading.open_files.end(), same);
  if (found != reading.open_files.end()) {
    const bool itself = found + 1 == reading.open_files.end();
    return reading.diagnostics.error(
        call.place_of_argument(0),
        itself ? std::string("this file reads itself")
               : fmt::format("this file reads itself again, by way of `{}`", reading.open_files.back().path.string()));
  }
  const std::uint32_t visit = reading.diagnostics.open(file->path.string(), call.place(), file->loaded.is_secret);
  reading.open_files.push_back({file->path, file->loaded.identity, visit});
  interpret_text(reading, file->loaded.bytes, visit);
  if (file->loaded.bytes.has_shrunk()) reading.diagnostics.error(call.place_of_argument(0), file_has_shrunk);
  reading.open_files.pop_back();
}

void course(Reading& reading, const Call& call) {
  if (reading.commands > 0) {
    return reading.error(call.place(), "`course` has to come before every other command");
  }
  const Course named = call.form.count() == 0 ? Course::any_year : course_of_year(call.name(0));
  if (named == Course::off) {
    return reading.error(call.place_of_argument(0), "there is no course of {}; the years are {}",
                         in_quotes(call.name(0)), years_in_words);
  }
  if (reading.options.course == Course::off) set_course(reading, named);
}

void reset_timer(Reading& reading, const Call&) { reading.builder.add_timer(ResetTimer{}); }

void print_timer(Reading& reading, const Call&) { reading.builder.add_timer(PrintTimer{}); }

void color(Reading& reading, const Call& call) { reading.builder.set_paint(call.vec(0)); }

void rect(Reading& reading, const Call& call) {
  reading.builder.add_rect(call.whole(0), call.whole(1), call.whole(2), call.whole(3));
}

}  // namespace penumbra::actions
