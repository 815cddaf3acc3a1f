// A file from which a render resumes after it was stopped, killed or moved to another machine.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rendering/picture_key.hpp"
#include "rendering/resumable_render.hpp"

namespace penumbra {

// The rays and the time of all sessions so far.
struct Spent {
  RayCounts rays;
  double seconds = 0;
};

std::vector<std::byte> encode_checkpoint(const PictureKey& key, const Spent& spent, const ResumableRender& render);

// A checkpoint that was read and is intact.
class Checkpoint {
 public:
  // Throws FileError 65, which calls the file `name`, if the bytes are damaged or not a checkpoint.
  Checkpoint(std::vector<std::byte> bytes, std::string name);

  const PictureKey& key() const { return key_; }
  const Spent& spent() const { return spent_; }

  // Throws FileError 65 unless it belongs to the picture with this key.
  void require(const PictureKey& key) const;

  // Brings a new render of the same picture to the state in the checkpoint. Throws FileError 65 if that state does not
  // fit the render.
  void restore(ResumableRender& render) const;

 private:
  std::vector<std::byte> bytes_;
  std::string name_;
  PictureKey key_;
  Spent spent_;
};

// The newest intact checkpoint, of a file and its previous version (base/atomic_file.hpp).
struct LastCheckpoint {
  std::optional<Checkpoint> checkpoint;  // none if there is no file
  std::string warning;                   // what is wrong with the file, if its previous version is used
};
// Throws FileError 65 if none is intact.
LastCheckpoint read_last_checkpoint(const std::filesystem::path& path);

// Whether there is such a regular file and it begins as a checkpoint does.
bool looks_like_checkpoint(const std::filesystem::path& path);

}  // namespace penumbra
