// The bytes of one file, copied or mapped, and the function through which every file of a scene is opened, so that
// tests and fuzzers can serve files from memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace penumbra {

// Owns the contents of a file. Small files are copied, so that an editor cannot truncate one while it is in use; large
// ones are mapped. The view stays valid when the object is moved.
class FileBytes {
 public:
  FileBytes() = default;
  explicit FileBytes(std::string text) : text_(std::move(text)) {}
  // Takes ownership of a mapping made by mmap.
  FileBytes(void* address, std::size_t size) : mapped_(static_cast<char*>(address), Unmap{size}) {}

  std::string_view view() const {
    return mapped_ ? std::string_view(mapped_.get(), mapped_.get_deleter().size) : std::string_view(text_);
  }

  // Declares that nothing before `offset` is needed soon, so that a mapped file does not add to the memory of the
  // scene.
  void release_before(std::size_t offset);

 private:
  struct Unmap {
    std::size_t size;
    void operator()(char* address) const;
  };

  std::string text_;
  std::unique_ptr<char, Unmap> mapped_;
  std::size_t released_ = 0;
};

struct LoadedFile {
  FileBytes bytes;
  std::string identity;  // equal for two paths that lead to the same file
  std::string problem;   // why it could not be read; empty if it was
  std::string near;      // a file of the same folder whose name is near, where there is none of this name
};

using FileLoader = std::function<LoadedFile(const std::filesystem::path&)>;

// Opens a regular file of the file system.
LoadedFile load_from_disk(const std::filesystem::path& path);

// The same for a file that may be truncated while it is in use: it is never mapped.
LoadedFile load_copy_from_disk(const std::filesystem::path& path);

// Standard input, read to its end once: later calls return the same bytes. More than `most` bytes are cut to most + 1.
LoadedFile load_standard_input(std::uint64_t most);

}  // namespace penumbra
