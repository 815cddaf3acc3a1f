// Identifies content: which scene a checkpoint belongs to, and whether a block of a file is what was written. Protects
// against accidents, not against forgery. The hash is XXH3 (xxhash.com), the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace penumbra {

// 128 bits: in practice no two different contents collide by chance.
struct ContentHash {
  std::uint64_t low = 0, high = 0;

  bool operator==(const ContentHash&) const = default;
};

// 32 hexadecimal digits.
std::string to_hex(const ContentHash& hash);

// The hash of a sequence of contents, given one after the other.
class ContentHasher {
 public:
  ContentHasher();
  ~ContentHasher();

  // The boundaries between contents matter.
  void add(std::span<const std::byte> content);
  ContentHash value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The checksum of one block of bytes, different for every seed.
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t seed);

}  // namespace penumbra
