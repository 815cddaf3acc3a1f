// The bytes of one file, copied or mapped, and the function through which every file of a scene is opened, so that
// tests and fuzzers can serve files from memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "base/mapped_file.hpp"

namespace penumbra {

// Files of a scene may have so many bytes in all, and so many come from standard input.
inline constexpr std::uint64_t most_bytes_read = std::uint64_t{4} << 30;
inline constexpr std::uint64_t most_bytes_from_pipe = std::uint64_t{1} << 30;

// Owns the contents of a file. Small files are copied, so that an editor cannot truncate one while it is in use; large
// ones are mapped. The view stays valid when the object is moved.
class FileBytes {
 public:
  FileBytes() = default;
  explicit FileBytes(std::string text) : text_(std::move(text)) {}
  explicit FileBytes(MappedFile mapped) : mapped_(std::move(mapped)) {}

  std::string_view view() const { return mapped_ ? mapped_.view() : std::string_view(text_); }

  // Whether somebody has made the file shorter since it was opened, so that a part of the view is zeros; has_gap() only
  // if that part was looked at.
  bool has_shrunk() const { return mapped_.has_shrunk(); }
  bool has_gap() const { return mapped_.has_gap(); }

  // Declares that nothing before `offset` is needed soon, so that a mapped file does not add to the memory of the
  // scene.
  void release_before(std::size_t offset) { mapped_.release_before(offset); }

 private:
  std::string text_;
  MappedFile mapped_;
};

// What to say if it has.
inline constexpr const char* file_has_shrunk = "the file became shorter while it was read";

struct LoadedFile {
  FileBytes bytes;
  std::string identity;    // equal for two paths that lead to the same file
  std::string problem;     // why it could not be read; empty if it was
  bool is_secret = false;  // not for everybody to read, and not named as a scene or a mesh: no message may show it
  std::string near;        // a file of the same folder whose name is near, where there is none of this name
};

using FileLoader = std::function<LoadedFile(const std::filesystem::path&)>;

// Opens a regular file of the file system; it may have most_bytes_read.
LoadedFile load_from_disk(const std::filesystem::path& path);

// The same for a file that may be truncated while it is in use: it is never mapped.
LoadedFile load_copy_from_disk(const std::filesystem::path& path);

// Standard input, read to its end once: later calls return the same bytes.
LoadedFile load_standard_input();

}  // namespace penumbra
