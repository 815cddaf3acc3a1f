#include "base/available_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using Bytes = std::optional<std::uint64_t>;

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

// The number after a word in a file of words and numbers, or the first number in the file if the word is empty.
Bytes number_after(const fs::path& path, std::string_view word) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  if (word.empty()) return file >> number ? Bytes(number) : std::nullopt;
  for (std::string found; file >> found;) {
    if (found == word) return file >> number ? Bytes(number) : std::nullopt;
  }
  return std::nullopt;
}

// The names of a group's files.
struct GroupFiles {
  const char *limit, *usage, *cache;  // cache: of files, which the kernel gives up first
};
constexpr GroupFiles version_1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles version_2{"memory.max", "memory.current", "inactive_file"};

std::uint64_t left_in_group(const fs::path& folder, const GroupFiles& files) {
  const Bytes limit = number_after(folder / files.limit, {}), usage = number_after(folder / files.usage, {});
  if (!limit || !usage) return unlimited;
  const std::uint64_t cache = number_after(folder / "memory.stat", files.cache).value_or(0);
  const std::uint64_t used = *usage - std::min(cache, *usage);
  return *limit - std::min(used, *limit);
}

// A limit of any group from that of the process up to the mount counts.
std::uint64_t left_in_groups(const fs::path& mount, fs::path group, const GroupFiles& files) {
  std::uint64_t left = left_in_group(mount, files);
  for (group = group.relative_path(); !group.empty(); group = group.parent_path()) {
    left = std::min(left, left_in_group(mount / group, files));
  }
  return left;
}

// The lines of /proc/self/cgroup are NUMBER:CONTROLLERS:GROUP; version 2 has no controllers there.
std::uint64_t left_in_all_groups(const fs::path& root) {
  std::uint64_t left = unlimited;
  std::ifstream file(root / "proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == line.npos) continue;
    const std::string controllers = ',' + line.substr(first + 1, second - first - 1) + ',';
    const fs::path group = line.substr(second + 1), mounts = root / "sys/fs/cgroup";
    if (controllers == ",,") left = std::min(left, left_in_groups(mounts, group, version_2));
    if (controllers.find(",memory,") != controllers.npos) {
      left = std::min(left, left_in_groups(mounts / "memory", group, version_1));
    }
  }
  return left;
}

// The pages of /proc/self/statm: the address space, then those in memory.
std::uint64_t pages_of_process(int column) {
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  for (int i = 0; i <= column; i++) file >> pages;
  return file ? pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

std::uint64_t left_of_address_space() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  return limit.rlim_cur - std::min<std::uint64_t>(pages_of_process(0), limit.rlim_cur);
}

}  // namespace

std::uint64_t available_memory(const fs::path& root) {
  const Bytes kilobytes = number_after(root / "proc/meminfo", "MemAvailable:");
  const std::uint64_t of_machine = kilobytes ? *kilobytes * 1024 : unlimited;
  return std::min({of_machine, left_in_all_groups(root), left_of_address_space()});
}

std::uint64_t resident_memory() { return pages_of_process(1); }

}  // namespace penumbra
