// Everything one reading of a scene file works on: what it has found wrong, the scene so far, the files it is in.
// This is what an action of the command table gets.
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

// One file that is being read.
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
  std::vector<std::string> files;    // all that were named, each once, as the user would find them
  std::size_t reads = 0;
  std::uint64_t bytes = 0;

  bool varies = false;                    // an expression was read
  bool stray_vertex = false;              // a `vertex` outside a polygon was told; those that follow it are not
  std::uint64_t objects_in_pictures = 0;  // objects that had been added when the last picture was taken
  std::optional<Place> after_pictures;    // the first object after the last picture

  void complain(const Place& place, const Complaint& complaint) {
    if (!complaint.empty()) diagnostics.error(place, complaint);
  }
};

// Does what one line says.
void interpret_line(Reading& reading, std::uint32_t visit, const Line& line);

// Does what all lines of an open file say.
void interpret_text(Reading& reading, FileBytes& bytes, std::uint32_t visit);

// Warns of a picture, the last one taken, that shows nothing.
void warn_of_empty_picture(Reading& reading, const Place& place);

// Says what is missing or odd at the end of everything, and takes the last picture if the file names none.
void finish_reading(Reading& reading);

// Reads a scene with files from `load`; with `text`, that instead of the contents of the first file.
SceneFile read_scene_with(const std::filesystem::path& path, std::optional<std::string> text,
                          const ReadOptions& options, FileLoader load, const Limits& limits = {});

// Opens a file that a command names; reports at the command if that fails. The file is relative to the innermost one.
struct NamedFile {
  std::filesystem::path path;
  LoadedFile loaded;
};
std::optional<NamedFile> open_named_file(Reading& reading, const Call& call);

}  // namespace penumbra
