// Short ways to read a scene from text, with other files in memory, and to look at the result.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "language/reading.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

using Files = std::map<std::string, std::string>;

inline FileLoader in_memory(const Files& files) {
  return [files](const std::filesystem::path& path) {
    LoadedFile loaded;
    const auto found = files.find(path.string());
    if (found == files.end()) {
      loaded.problem = "no such file";
    } else {
      loaded.bytes = FileBytes(found->second);
      loaded.identity = path.lexically_normal().string();
    }
    return loaded;
  };
}

// Reads `text` as the file s.cli beside `files`.
inline SceneFile read(const std::string& text, const ReadOptions& options = {}, Files files = {}) {
  files["s.cli"] = text;
  return read_scene_with("s.cli", std::nullopt, options, in_memory(files));
}

// All diagnostics, as printed on a terminal.
inline std::string told(const SceneFile& file) {
  std::string text;
  for (const Diagnostic& d : file.diagnostics) text += to_string(d);
  return text;
}

inline std::string told(const std::string& text, const ReadOptions& options = {}, const Files& files = {}) {
  return told(read(text, options, files));
}

inline std::vector<Picture> pictures(const SceneFile& file) {
  std::vector<Picture> list;
  for (const Action& action : file.actions) {
    if (const auto* picture = std::get_if<Picture>(&action)) list.push_back(*picture);
  }
  return list;
}

// The scene of the only picture of a text without errors.
inline Scene scene_of(const std::string& text, const ReadOptions& options = {}, const Files& files = {}) {
  const SceneFile file = read(text, options, files);
  EXPECT_FALSE(has_error(file.diagnostics)) << told(file);
  const std::vector<Picture> list = pictures(file);
  EXPECT_EQ(list.size(), 1u) << text;
  if (!list.empty()) return *list.front().scene;
  throw std::runtime_error("there is no picture to look at");  // fails this test, not the whole run
}

template <class Kind>
const Kind& shape_of(const Object& object) {
  return std::get<Kind>(object.shape);
}

// The corners of a stored triangle.
inline std::vector<Vec3> corners(const Scene& scene, std::size_t triangle) {
  std::vector<Vec3> list;
  for (std::size_t k = 0; k < 3; k++) {
    const std::size_t v = 3 * std::size_t{scene.triangles->indices.at(3 * triangle + k)};
    const ZeroedVector<float>& f = scene.triangles->vertices;
    list.push_back({f.at(v), f.at(v + 1), f.at(v + 2)});
  }
  return list;
}

inline void expect_near(Vec3 a, Vec3 b, double tolerance = 1e-12) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

inline const std::string light = "light 0 9 0 1 1 1\n";
inline const std::string ball = "sphere 1 0 0 -4\n";
inline const std::string triangle = "begin\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nend\n";

}  // namespace penumbra
