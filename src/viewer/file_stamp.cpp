#include "viewer/file_stamp.hpp"

#include <sys/stat.h>
#include <time.h>

namespace penumbra {
namespace {

constexpr std::int64_t second = 1'000'000'000;
// A file system takes its times from a clock that lags by up to a tick of the kernel.
constexpr std::int64_t clock_tick = 12'000'000;

std::int64_t nanoseconds_of(const timespec& time) { return time.tv_sec * second + time.tv_nsec; }

}  // namespace

StampClock StampClock::now() {
  timespec time{};
  ::clock_gettime(CLOCK_REALTIME, &time);
  return {nanoseconds_of(time)};
}

FileStamp stamp_of(const std::filesystem::path& path, StampClock before) {
  FileStamp stamp;
  stamp.path = path;
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return stamp;
  stamp.exists = true;
  stamp.device = status.st_dev;
  stamp.inode = status.st_ino;
  stamp.size = static_cast<std::uint64_t>(status.st_size);
  stamp.modified = nanoseconds_of(status.st_mtim);
  stamp.changed = nanoseconds_of(status.st_ctim);
  // A time in the future means nothing.
  stamp.unsure =
      stamp.changed > before.nanoseconds - clock_tick && stamp.changed < StampClock::now().nanoseconds + second;
  return stamp;
}

FileChange change_of(const std::vector<FileStamp>& files) {
  FileChange change = FileChange::none;
  for (const FileStamp& old : files) {
    const FileStamp now = stamp_of(old.path, StampClock::now());
    const bool changed = old.unsure || now.exists != old.exists || now.device != old.device || now.inode != old.inode ||
                         now.size != old.size || now.modified != old.modified || now.changed != old.changed;
    if (changed && now.unsure) return FileChange::fresh;
    if (changed) change = FileChange::settled;
  }
  return change;
}

}  // namespace penumbra
