#include "app/files/path_table.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sysexits.h>

#include "base/atomic_file.hpp"

namespace penumbra {

const std::filesystem::path& PathTable::canonical_folder(const std::filesystem::path& folder) {
  const auto [found, is_new] = folders_.try_emplace(folder.string());
  if (is_new) {
    std::error_code error;
    found->second = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, error);
    if (error) found->second = std::filesystem::absolute(folder, error).lexically_normal();
  }
  return found->second;
}

void PathTable::add(const std::filesystem::path& path, const Kind& kind) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode) || S_ISSOCK(status.st_mode))) return;

  const Use use{path.string(), std::string(kind.purpose), kind.is_written};
  const auto require_alone = [&use](auto& uses, const auto& key) {
    const auto [found, is_new] = uses.try_emplace(key, use);
    const Use& other = found->second;
    if (is_new || (!other.is_written && !use.is_written)) return;
    throw FileError(EX_USAGE, fmt::format("`{}` ({}) and `{}` ({}) are the same file: give each one of its own",
                                          other.name, other.purpose, use.name, use.purpose));
  };
  const std::filesystem::path target = target_of_links(path);
  require_alone(by_place_, (canonical_folder(target.parent_path()) / target.filename()).lexically_normal().string());
  if (exists && kind.has_content) require_alone(by_content_, std::pair(status.st_dev, status.st_ino));
}

}  // namespace penumbra
