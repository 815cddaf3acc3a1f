// A file of blocks, each with a checksum, so that damage and truncation are noticed, and where. The checksum includes
// the block's number; an empty block marks the end.
//
//   8 bytes  PENUMBRA
//   4        the FileKind
//   4        the version of the format
//   then for each block: 8 bytes length, 8 bytes checksum, the bytes
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/atomic_file.hpp"

namespace penumbra {

enum class FileKind : std::uint32_t { checkpoint = 1, part = 2 };

// The kind in words, for messages.
const char* name_of(FileKind kind);

// Whether the bytes begin as a file of this kind, in any version of the format.
bool is_sealed(std::span<const std::byte> bytes, FileKind kind);

class SealedWriter {
 public:
  // Writes after the bytes of `before`.
  explicit SealedWriter(FileKind kind, std::vector<std::byte> before = {});

  // Declares that so many blocks will follow, most of them of at most so many bytes.
  void expect(std::size_t blocks, std::size_t bytes_each);
  void add(std::span<const std::byte> block);  // ignored if empty
  std::vector<std::byte> finish();

 private:
  void write(std::span<const std::byte> block);

  ArchiveWriter out_;
  std::uint64_t number_ = 0;
};

// Damage throws FileError 65 with the file's name and the place.
class SealedReader {
 public:
  // The bytes must outlive this.
  SealedReader(std::span<const std::byte> bytes, FileKind kind, std::string name);

  // The next block; empty after the last.
  std::span<const std::byte> next();

  // Hands the last block to `use(archive)`, which must read all of it.
  template <class Use>
  void read(std::span<const std::byte> block, const Use& use) const {
    try {
      ArchiveReader archive(block);
      use(archive);
      if (!archive.at_end()) throw ArchiveError("it has more data than expected");
    } catch (const ArchiveError& error) {
      fail(error.what());
    }
  }

  // Reports that the last block is wrong.
  [[noreturn]] void fail(const std::string& why) const;

 private:
  std::span<const std::byte> bytes_;
  FileKind kind_;
  std::string name_;
  std::size_t position_ = 0, block_start_ = 0;
  std::uint64_t number_ = 0;
};

}  // namespace penumbra
