// All files that a command reads and writes, so that none of them serves two purposes: a picture over its own scene, a
// checkpoint under the name of a picture.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace penumbra {

class PathTable {
 public:
  // Add a file and its purpose in the user's words: "-o", "--stats", "the scene". A file may be read twice, but not
  // written twice, or read and written. Two names are of one file if they lead to the same place or, through hard
  // links, to the same content. Devices and sockets may serve any number of purposes. Throw FileError: 64 with both
  // names, 73 where links form a circle.
  void reads(const std::filesystem::path& path, std::string_view purpose) { add(path, {purpose, false, true}); }
  void writes(const std::filesystem::path& path, std::string_view purpose) { add(path, {purpose, true, true}); }
  // The same for a file that may be a hard link to another one of the command: only its place counts.
  void writes_place(const std::filesystem::path& path, std::string_view purpose) { add(path, {purpose, true, false}); }

 private:
  struct Use {
    std::string name, purpose;
    bool is_written = false;
  };

  struct Kind {
    std::string_view purpose;
    bool is_written, has_content;
  };

  void add(const std::filesystem::path& path, const Kind& kind);
  const std::filesystem::path& canonical_folder(const std::filesystem::path& folder);

  std::map<std::string, Use> by_place_;
  std::map<std::pair<dev_t, ino_t>, Use> by_content_;
  std::map<std::string, std::filesystem::path> folders_;  // canonical; an animation has thousands of files in one
};

}  // namespace penumbra
