// A file as memory: pages are read when they are looked at. If the file becomes shorter meanwhile, the system answers
// with SIGBUS; here, what is missing then reads as zeros instead, and the owner can ask (as libwayland does for shared
// memory).
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

namespace penumbra {

class MappedFile {
 public:
  MappedFile() = default;
  // Maps the first `size` bytes of an open file, of which it keeps its own descriptor. Empty if that is not possible.
  MappedFile(int descriptor, std::size_t size);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept { swap(other); }
  MappedFile& operator=(MappedFile&& other) noexcept {
    swap(other);
    return *this;
  }

  explicit operator bool() const { return address_ != nullptr; }
  std::string_view view() const { return {address_, size_}; }

  // Whether the file has become shorter.
  bool has_shrunk() const;
  // The same, but only if what is missing was looked at: cheap enough to ask after every line.
  bool has_gap() const;

  // Lets the system forget what lies before `offset`, in large steps.
  void release_before(std::size_t offset);

 private:
  void swap(MappedFile& other) noexcept {
    std::swap(address_, other.address_);
    std::swap(size_, other.size_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(slot_, other.slot_);
    std::swap(released_, other.released_);
  }

  char* address_ = nullptr;
  std::size_t size_ = 0;
  int descriptor_ = -1;
  std::size_t slot_ = 0;  // where the signal handler finds it
  std::size_t released_ = 0;
};

}  // namespace penumbra
