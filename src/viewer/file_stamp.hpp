// Whether a file is still the one that was read. Editors save in place or by renaming; both change its stamp.
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
  // It was written at about the time when it was read, so what was read may be older than this stamp.
  bool unsure = false;
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t modified = 0, changed = 0;  // nanoseconds
};

// The stamp of a file that was read after `before`.
FileStamp stamp_of(const std::filesystem::path& path, StampClock before);

enum class FileChange {
  none,
  fresh,  // within the last moments: whoever writes may not be done, and a stamp could not tell what comes next
  settled
};

// Whether any of the files is another now, has come or gone, or was unsure.
FileChange change_of(const std::vector<FileStamp>& files);

}  // namespace penumbra
