// The state of reading one scene file: the errors found, the scene so far, the open files. Every action of the command
// table works on it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "language/command.hpp"
#include "language/diagnostic_list.hpp"
#include "language/expression.hpp"
#include "language/file_bytes.hpp"
#include "language/limits.hpp"
#include "language/scene_builder.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

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
  FileLoader load;
  Limits limits;
  DiagnosticList diagnostics;
  SceneBuilder builder;
  Expressions expressions;

  std::vector<OpenFile> open_files;  // the innermost last
  std::vector<std::string> files;    // all that were named, each once, by paths that the user can open
  std::size_t reads = 0;
  std::uint64_t bytes = 0;

  bool varies = false;                        // an expression was read
  bool stray_vertex = false;                  // a `vertex` outside a polygon was reported; the next ones are not
  std::uint64_t objects_in_pictures = 0;      // objects added before the last picture was taken
  std::optional<SourcePlace> after_pictures;  // the first object after the last picture

  void report(const SourcePlace& place, const Problem& problem) {
    if (!problem.empty()) diagnostics.error(place, problem);
  }
};

// Executes one line.
void interpret_line(Reading& reading, std::uint32_t visit, const Line& line);

// Executes all lines of an open file.
void interpret_text(Reading& reading, FileBytes& bytes, std::uint32_t visit);

// Warns if the last picture taken has no object or no light.
void warn_of_empty_picture(Reading& reading, const SourcePlace& place);

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
