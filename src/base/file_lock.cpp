#include "base/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sysexits.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/atomic_file.hpp"

namespace penumbra {
namespace {

// Whether the name still leads to the open file: its owner removes it before the lock is free.
bool is_named(int descriptor, const std::filesystem::path& name) {
  struct stat open {
  }, named{};
  return ::fstat(descriptor, &open) == 0 && ::stat(name.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

}  // namespace

std::filesystem::path lock_file_of(const std::filesystem::path& path) {
  const std::filesystem::path target = target_of_links(path);
  return target.parent_path() / fmt::format(".{}.penumbra-lock", target.filename().string().substr(0, 200));
}

FileLock::FileLock(const std::filesystem::path& path, const std::string& held) : file_(lock_file_of(path)) {
  constexpr int most_tries = 100;  // some file systems number a file anew each time
  for (int tries = 1;; tries++) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0) {
      throw FileError(EX_CANTCREAT, fmt::format("cannot create `{}`: {}", file_.string(), std::strerror(errno)));
    }
    const bool is_held = ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!is_held && (is_named(descriptor_, file_) || tries == most_tries)) return;
    ::close(descriptor_);
    if (is_held) throw FileError(EX_CANTCREAT, held);
  }
}

FileLock::~FileLock() {
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace penumbra
