// A file from which a render goes on after it was stopped, killed or moved to another machine.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rendering/picture_key.hpp"
#include "rendering/resumable_render.hpp"

namespace penumbra {

// What all sittings so far have taken.
struct Spent {
  RayCounts rays;
  double seconds = 0;
};

std::vector<std::byte> encode_checkpoint(const PictureKey& key, const Spent& spent, const ResumableRender& render);

// A checkpoint that was read and found whole.
class Checkpoint {
 public:
  // Throws FileError 65, with `name` for the file's, where the bytes are damaged or no checkpoint.
  Checkpoint(std::vector<std::byte> bytes, std::string name);

  const PictureKey& key() const { return key_; }
  const Spent& spent() const { return spent_; }

  // Throws FileError 65 unless it is of the picture with this key.
  void require(const PictureKey& key) const;

  // Puts a new render where the one of the checkpoint stood, which must have been of the same picture.
  // Throws FileError 65 where that cannot be.
  void restore(ResumableRender& render) const;

 private:
  std::vector<std::byte> bytes_;
  std::string name_;
  PictureKey key_;
  Spent spent_;
};

// The newest checkpoint of a file and its previous one (base/atomic_file.hpp) that is whole.
struct LastCheckpoint {
  std::optional<Checkpoint> checkpoint;  // none if there is no file
  std::string warning;                   // what is wrong with the newest, where it is not that one
};
// Throws FileError 65 where none is whole.
LastCheckpoint read_last_checkpoint(const std::filesystem::path& path);

// Whether the file begins as a checkpoint does, or is empty.
bool may_be_checkpoint(const std::filesystem::path& path);

}  // namespace penumbra
