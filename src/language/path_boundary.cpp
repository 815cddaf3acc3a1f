#include "language/path_boundary.hpp"

#include <algorithm>
#include <system_error>

namespace penumbra {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;

// The absolute path without links; empty if it cannot be found out.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  fs::path target = fs::absolute(path, error);
  for (int links = 0; links < most_links && !error; links++) {
    target = fs::weakly_canonical(target, error);
    std::error_code missing;
    if (error || !fs::is_symlink(target, missing)) return error ? fs::path() : target;
    target = target.parent_path() / fs::read_symlink(target, error);  // a link to what is not there yet
  }
  return {};
}

bool is_below(const fs::path& folder, const fs::path& file) {
  const fs::path whole = resolved(folder);
  return !whole.empty() && std::mismatch(whole.begin(), whole.end(), file.begin(), file.end()).first == whole.end();
}

}  // namespace

bool is_beside_scene(const fs::path& file, const fs::path& scene) {
  return is_below(scene.has_parent_path() ? scene.parent_path() : ".", resolved(file));
}

bool is_in_reach(const fs::path& file, const fs::path& scene) {
  return is_below(".", resolved(file)) || is_beside_scene(file, scene);
}

}  // namespace penumbra
