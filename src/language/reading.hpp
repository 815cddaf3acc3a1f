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

// What makes a file look as if it were written in the order of 2018.
struct OrderOf2018 {
  bool bright_light = false;   // a light with a colour below 0 or above 1
  bool small_position = false; // a light within the unit cube
  bool ambient_first = false;  // a surface with more ambient than diffuse light
  int spheres = 0, spheres_behind = 0;  // behind: with a centre whose z is above 0
  std::optional<Place> first_sphere;

  int signs() const { return bright_light + small_position + ambient_first + (spheres > 0 && spheres == spheres_behind); }
};

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
  Course course = Course::off;            // that of the options, or else of the scene
  Highlight highlight = Highlight::blinn; // of surfaces to come that leave it open
  OrderOf2018 order_of_2018;
  FileLoader load;
  Limits limits;
  DiagnosticList diagnostics;
  SceneBuilder builder;
  Expressions expressions;

  std::vector<OpenFile> open_files;  // the innermost last
  std::vector<std::string> files;    // all that were named, each once, as the user would find them
  std::size_t reads = 0;
  std::uint64_t commands = 0;
  std::uint64_t bytes = 0;

  bool varies = false;                    // an expression was read
  bool stray_vertex = false;              // a `vertex` outside a polygon was told; those that follow it are not
  std::uint64_t objects_in_pictures = 0;  // objects that had been added when the last picture was taken
  std::optional<Place> after_pictures;    // the first object after the last picture

  void complain(const Place& place, const Complaint& complaint) {
    if (!complaint.empty()) diagnostics.error(place, complaint);
  }
};

// What a message about a file in the order of 2018 advises.
inline constexpr std::string_view how_to_read_2018 = "--course=2018, or `course 2018` in the first line, reads that order";

// Makes the course's rules those of the reading and of the scene so far.
void set_course(Reading& reading, Course course);

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
