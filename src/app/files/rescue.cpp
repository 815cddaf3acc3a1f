#include "app/files/rescue.hpp"

#include <fmt/format.h>

#include "base/atomic_file.hpp"
#include "image/image_file.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

// The first such name in the folder that no file has.
fs::path free_name(const fs::path& folder, const fs::path& name) {
  std::error_code error;
  for (int number = 1;; number++) {
    const std::string end = number == 1 ? "rescued" : fmt::format("rescued-{}", number);
    // A name that was too long must not be so again.
    fs::path file =
        folder / fmt::format("{}.{}{}", name.stem().string().substr(0, 100), end, name.extension().string());
    if (fs::symlink_status(file, error).type() == fs::file_type::not_found || error) return file;
  }
}

}  // namespace

std::optional<fs::path> rescue(const fs::path& path, std::span<const std::byte> bytes) {
  std::error_code error;
  const bool is_pipe = path == standard_output || fs::is_other(path, error);
  const fs::path name = is_pipe ? fs::path("picture.png") : path.filename();
  const fs::path temporary = fs::temp_directory_path(error);
  for (const fs::path& folder : {is_pipe ? fs::path() : path.parent_path(), fs::path(), temporary}) {
    const fs::path file = free_name(folder, name);
    try {
      write_file_atomically(file, bytes);
      return file;
    } catch (const FileError&) {
      continue;  // with the next folder
    }
  }
  return std::nullopt;
}

}  // namespace penumbra
