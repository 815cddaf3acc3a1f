// The bytes of one file, copied or mapped, and the function through which every file of a scene is opened, so that
// tests and fuzzers can serve files from memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace penumbra {

// Owns the contents of a file. Small files are copied, so that an editor cannot truncate one while it is in use; large
// ones are mapped. The view stays valid when the object is moved.
class FileBytes {
 public:
  FileBytes() = default;
  explicit FileBytes(std::string text);
  FileBytes(FileBytes&& other) noexcept;
  FileBytes& operator=(FileBytes&& other) noexcept;
  ~FileBytes();

  // Takes ownership of a mapping made by mmap.
  static FileBytes from_mapping(void* address, std::size_t size);

  std::string_view view() const;

  // Declares that nothing before `offset` is needed soon, so that a mapped file does not add to the memory of the
  // scene.
  void release_before(std::size_t offset);

 private:
  void unmap();

  std::string text_;
  char* mapped_ = nullptr;
  std::size_t size_ = 0;
  std::size_t released_ = 0;
};

struct LoadedFile {
  FileBytes bytes;
  std::string identity;  // equal for two paths that lead to the same file
  std::string problem;   // why it could not be read; empty if it was
};

using FileLoader = std::function<LoadedFile(const std::filesystem::path&)>;

// Opens a regular file of the file system.
LoadedFile load_from_disk(const std::filesystem::path& path);

// The same for a file that may be truncated while it is in use: it is never mapped.
LoadedFile load_copy_from_disk(const std::filesystem::path& path);

// Standard input, read to its end once: later calls return the same bytes. More than `most` bytes are cut to most + 1.
LoadedFile load_standard_input(std::uint64_t most);

}  // namespace penumbra
