// Scenes from arbitrary bytes. The first byte sets the options; the rest is the scene and, separated by lines with
// `%%`, the files it may name: a.cli, b.cli, m.obj, m.ply. Nothing else exists, and the disk is never touched.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "invariants.hpp"
#include "language/reading.hpp"

namespace {

using namespace penumbra;

constexpr std::string_view separator = "\n%%\n";
constexpr std::array<std::string_view, 5> names{"s.cli", "a.cli", "b.cli", "m.obj", "m.ply"};

std::vector<std::string> split(std::string_view input) {
  std::vector<std::string> parts;
  while (parts.size() + 1 < names.size()) {
    const std::size_t end = input.find(separator);
    if (end == std::string_view::npos) break;
    parts.emplace_back(input.substr(0, end));
    input.remove_prefix(end + separator.size());
  }
  parts.emplace_back(input);
  return parts;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const ReadOptions options{.course = static_cast<Course>((data[0] & 1u) != 0 ? 1 + (data[0] >> 2) % 5 : 0),
                            .lenient = (data[0] & 2) != 0,
                            .allow_paths = true};
  const std::vector<std::string> parts = split({reinterpret_cast<const char*>(data) + 1, size - 1});
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
  const SceneFile file = read_scene_with("s.cli", std::nullopt, options, load, limits);
  for (const Diagnostic& diagnostic : file.diagnostics) require(!to_string(diagnostic).empty());
  require(file.actions.empty() == has_error(file.diagnostics));
  const Scene* last = nullptr;
  for (const Action& action : file.actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (picture == nullptr || picture->scene.get() == last) continue;
    last = picture->scene.get();
    require_sound(*last);
  }
  return 0;
}
