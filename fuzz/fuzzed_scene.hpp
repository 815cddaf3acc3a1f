// Scenes from arbitrary bytes. The first byte sets the options; the rest is the scene and, separated by lines with
// `%%`, the files it may name: a.cli, b.cli, m.obj, m.ply. Nothing else exists, and the disk is never touched.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "language/reading.hpp"

namespace penumbra {

inline std::vector<std::string> split_files(std::string_view input, std::size_t most) {
  constexpr std::string_view separator = "\n%%\n";
  std::vector<std::string> parts;
  while (parts.size() + 1 < most) {
    const std::size_t end = input.find(separator);
    if (end == std::string_view::npos) break;
    parts.emplace_back(input.substr(0, end));
    input.remove_prefix(end + separator.size());
  }
  parts.emplace_back(input);
  return parts;
}

// Reads the scene; `size` is at least 1.
inline SceneFile read_fuzzed_scene(const std::uint8_t* data, std::size_t size) {
  constexpr std::array<std::string_view, 5> names{"s.cli", "a.cli", "b.cli", "m.obj", "m.ply"};
  const ReadOptions options{.course = static_cast<Course>((data[0] & 1u) != 0 ? 1 + (data[0] >> 2) % 5 : 0),
                            .lenient = (data[0] & 2) != 0,
                            .allow_paths = true};
  const std::vector<std::string> parts = split_files({reinterpret_cast<const char*>(data) + 1, size - 1}, names.size());
  const FileLoader load = [&](const std::filesystem::path& path) {
    LoadedFile loaded;
    const auto i = static_cast<std::size_t>(std::find(names.begin(), names.end(), path.string()) - names.begin());
    if (i < parts.size()) {
      loaded.bytes = FileBytes(parts[i]);
      loaded.identity = path.string();
    } else {
      loaded.problem = "no such file";
    }
    return loaded;
  };
  Limits limits;
  limits.reads = 100;
  limits.bytes = 1 << 20;
  limits.copies = 10'000;
  return read_scene_with("s.cli", std::nullopt, options, load, limits);
}

}  // namespace penumbra
