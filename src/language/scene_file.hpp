// Reads `.cli` text and returns what it asks for: the pictures to render, in the order of the file, each with the scene
// as it stood at that line.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/content_hash.hpp"
#include "language/diagnostic_list.hpp"
#include "scene/scene.hpp"

namespace penumbra {

// A filled rectangle of the 2-D test commands, painted over a picture after it is rendered: columns x0..x1-1, rows
// H-y1..H-1-y0 counted from the top, clipped to the picture.
struct PaintedRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  Color color{1, 1, 1};
};

// What warnings about a picture speak of.
enum class Topic : std::uint8_t { picture, rays, camera, lens, area_light, gloss, motion };
inline constexpr std::size_t topic_count = 7;

// Where the scene speaks of each last, before the picture is taken.
using TopicPlaces = std::array<std::optional<Place>, topic_count>;

// `render`, `write FILE`, or the end of a file that has neither.
struct Picture {
  std::string file;  // as written in the scene; empty if it names none
  std::shared_ptr<const Scene> scene;
  std::vector<PaintedRect> rects;
  TopicPlaces places;

  bool speaks_of(Topic topic) const { return places[static_cast<std::size_t>(topic)].has_value(); }
  // Where it does; else, where the picture is taken.
  Place place_of(Topic topic) const {
    return speaks_of(topic) || topic == Topic::picture ? places[static_cast<std::size_t>(topic)].value_or(Place())
                                                       : place_of(Topic::picture);
  }
};
struct ResetTimer {};
struct PrintTimer {};
using Action = std::variant<Picture, ResetTimer, PrintTimer>;

// What one reading of a file found.
struct ReadContent {
  std::string file;  // by a path that the user can open
  ContentHash hash;
  std::string problem;  // why it could not be read; empty if it was
};

// The line that made a light or a surface, by which people know it.
struct CommandPlace {
  std::string_view command;  // empty: no command made it (the surface of a scene before any)
  std::int64_t line = 0;     // from 1
  std::string file;          // by a path that the user can open; empty: the scene file itself
};

struct SceneFile {
  std::vector<Action> actions;          // empty if there is any error
  std::vector<Diagnostic> diagnostics;  // errors and warnings in the order of the file
  ContentHash hash;                     // of the bytes of all files in the order of reading; 0 unless requested
  // Of all lights and surfaces of the last picture, in the order of its scene.
  std::vector<CommandPlace> lights, surfaces;
  // All files that were opened or should have been, each once, by paths that the user can open.
  std::vector<std::string> files;
  std::vector<ReadContent> contents;  // of each reading of a file, in their order; empty unless the hash was requested
  bool varies = false;                // some number is an {expression}: other moments may give other pictures
  bool found = true;                  // false: the scene file itself could not be opened
};

// The time, for numbers written as {expression}: the number of the frame, and t, which runs from 0 to 1 over the frames
// of an animation. Outside an animation, both are 0.
struct Moment {
  double frame = 0, t = 0;
};

struct ReadOptions {
  Course course = Course::off;  // if not off, it wins over the scene's own `course`
  bool lenient = false;         // commands that only other programs know are skipped with a warning
  bool allow_paths = false;     // the scene may name files anywhere (path_boundary.hpp)
  bool hash = false;            // compute the hash of the files
  bool edited = false;          // the files may be rewritten meanwhile: large ones are copied, not mapped
  Moment moment = {};
};

// The scene file of this name is standard input; names in it are then relative to the working folder.
inline constexpr const char* standard_input = "-";

// Reads the file and all files that it names. Never throws because of their contents.
SceneFile read_scene(const std::filesystem::path& path, const ReadOptions& options);

// The same for text already in memory; errors call it `path`, and relative names start from there.
SceneFile read_scene_text(std::string text, const std::filesystem::path& path, const ReadOptions& options);

}  // namespace penumbra
