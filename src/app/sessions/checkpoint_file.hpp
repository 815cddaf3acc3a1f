// The file of a run's checkpoint, which belongs to this run alone while this object lives.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/file_lock.hpp"
#include "rendering/checkpoint.hpp"

namespace penumbra {

class CheckpointFile {
 public:
  // Throws FileError 73 if another run has the file, or if writing to it would replace a file of another kind.
  CheckpointFile(std::filesystem::path path, bool resume);

  // The checkpoint to resume from, with a warning if it is not the newest. Throws FileError 65 if none is intact.
  LastCheckpoint read();

  // Writes the state of a render; the one before stays as the previous version. A failure is reported, once in a row,
  // and costs nothing but this checkpoint. Returns its exit code, 0 if there is none.
  int save(const PictureKey& key, const Spent& spent, const ResumableRender& render);
  // The two halves of this: encoding, which needs the render, and writing, which does not. The first returns nothing
  // where there is not enough memory.
  std::vector<std::byte> encode(const PictureKey& key, const Spent& spent, const ResumableRender& render);
  int write(std::span<const std::byte> bytes);

  // Removes the checkpoint and its previous version, and reports what cannot be removed.
  void remove() const;

 private:
  void require_replaceable(const std::filesystem::path& file) const;
  int report_failure(std::string_view why, int exit_code);

  std::filesystem::path path_;
  FileLock lock_;
  bool keeps_previous_ = true;  // unless the newest is damaged
  bool fails_ = false;          // and that was reported
};

}  // namespace penumbra
