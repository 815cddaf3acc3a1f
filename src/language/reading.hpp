// The state of reading one scene file: the errors found, the scene so far, the open files. Every action of the command
// table works on it.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "language/command.hpp"
#include "language/diagnostic_list.hpp"
#include "language/expression.hpp"
#include "language/file_bytes.hpp"
#include "language/plain_line.hpp"
#include "language/scene_builder.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

// What makes a file look as if it were written in the order of 2018.
struct OrderOf2018 {
  bool bright_light = false;            // a light with a colour below 0 or above 1
  bool small_position = false;          // a light within the unit cube
  bool ambient_first = false;           // a surface with more ambient than diffuse light
  int spheres = 0, spheres_behind = 0;  // behind: with a centre whose z is above 0
  std::optional<SourcePlace> first_sphere;

  int signs() const {
    return bright_light + small_position + ambient_first + (spheres > 0 && spheres == spheres_behind);
  }
};

// A file that is being read.
struct OpenFile {
  std::filesystem::path path;
  std::string identity;
  std::uint32_t visit = 0;
};

struct Reading {
  Reading(const ReadOptions& read_options, FileLoader loader, const Limits& bounds)
      : options(read_options),
        load(std::move(loader)),
        limits(bounds),
        builder(bounds),
        expressions(read_options.moment) {}

  ReadOptions options;
  Course course = Course::off;             // that of the options, or else of the scene
  Highlight highlight = Highlight::blinn;  // of surfaces to come that leave it open
  OrderOf2018 order_of_2018;
  FileLoader load;
  Limits limits;
  DiagnosticList diagnostics;
  SceneBuilder builder;
  Expressions expressions;

  std::vector<OpenFile> open_files;  // the innermost last
  std::vector<std::string> files;    // all that were named, each once, by paths that the user can open
  std::size_t reads = 0;
  std::uint64_t commands = 0;
  PlainLine plain_line;  // the last one read; kept because it is large
  std::uint64_t bytes = 0;

  std::map<std::string, SourcePlace> written;  // where each file was named by `write`, by its path in normal form
  std::array<std::optional<SourcePlace>, topic_count> topics;  // where the scene spoke of each last

  bool varies = false;                        // an expression was read
  bool stray_vertex = false;                  // a `vertex` outside a polygon was reported; the next ones are not
  std::uint64_t objects_in_pictures = 0;      // objects added before the last picture was taken
  std::optional<SourcePlace> after_pictures;  // the first object after the last picture

  // Reports an error whose sentence is formatted as by fmt::format.
  template <class... Values>
  void error(const SourcePlace& place, fmt::format_string<Values...> sentence, Values&&... values) {
    diagnostics.error(place, fmt::format(sentence, std::forward<Values>(values)...));
  }
  // Remembers that a command speaks of a topic.
  void note(Topic topic, const Call& call) { topics[static_cast<std::size_t>(topic)] = call.place(); }
  // Reports a problem, if it is one, at a command.
  void report(const Call& call, const Problem& problem) {
    if (!problem.empty()) diagnostics.error(call.place(), problem);
  }
};

// What a message about a file in the order of 2018 advises.
inline constexpr std::string_view how_to_read_2018 =
    "--course=2018, or `course 2018` in the first line, reads that order";

// Applies the course's rules to the rest of the reading and to the scene so far.
void set_course(Reading& reading, Course course);

// Executes one line.
void interpret_line(Reading& reading, std::uint32_t visit, const Line& line);

// Executes all lines of an open file.
void interpret_text(Reading& reading, FileBytes& bytes, std::uint32_t visit);

// Takes a picture of the scene as it stands. Warns if it has no object or no light.
void take_picture(Reading& reading, std::string file, const SourcePlace& place);

// Reports what is missing or odd once everything is read, and takes a picture if the scene asks for none.
void finish_reading(Reading& reading);

// Reads a scene whose files come from `load`; if `text` is given, it replaces the contents of the first file.
SceneFile read_scene_with(const std::filesystem::path& path, std::optional<std::string> text,
                          const ReadOptions& options, FileLoader load, const Limits& limits = {});

// Opens a file that a command names, by a path relative to the innermost file; reports a failure at the command.
struct NamedFile {
  std::filesystem::path path;
  LoadedFile loaded;
};
std::optional<NamedFile> open_named_file(Reading& reading, const Call& call);

}  // namespace penumbra
