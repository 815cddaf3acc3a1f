// A lock that dies with its process, however that ends: what two runs must not do at once with the same file.
#pragma once

#include <filesystem>
#include <string>

namespace penumbra {

// The file whose lock stands for `path`: hidden, beside the file at the end of the path's links.
std::filesystem::path lock_file_of(const std::filesystem::path& path);

// Holds the lock of a path while it lives, and removes the lock's file at the end. A killed run leaves that file, but
// no lock. Where the file system has no locks, there is nothing to hold.
class FileLock {
 public:
  // Throws FileError 73 if another process holds the lock, in the words of `held`, or if its file cannot be created.
  FileLock(const std::filesystem::path& path, const std::string& held);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_;
};

}  // namespace penumbra
