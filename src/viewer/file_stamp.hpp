// Detects whether a file has changed since it was read. Editors save in place or by renaming; both change its stamp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace penumbra {

// The file system's clock, nanoseconds.
struct StampClock {
  std::int64_t nanoseconds = 0;

  static StampClock now();
};

struct FileStamp {
  std::filesystem::path path;
  bool exists = false;
  // It was written at about the time it was read, so what was read may be older than this stamp.
  bool unsure = false;
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t modified = 0, changed = 0;  // nanoseconds
};

// The stamp of a file that was read after `before`.
FileStamp stamp_of(const std::filesystem::path& path, StampClock before);

enum class FileChange {
  none,
  fresh,  // changed just now: the writer may not be done, and the stamp may not show the next change
  settled
};

// Whether any of the files has changed, appeared or vanished, or was unsure.
FileChange change_of(const std::vector<FileStamp>& files);

}  // namespace penumbra
