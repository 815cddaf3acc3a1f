// Turns plain values into bytes and back: numbers as they are in memory (x86: little endian), strings and lists after
// their length. Both archives are called in the same way, so that one function, serialize(archive, x), describes a
// structure for both.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace penumbra {

// The bytes cannot come from an ArchiveWriter.
struct ArchiveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
concept ArchivedNumber = std::is_arithmetic_v<T> && !std::same_as<T, bool>;

// What serialize() takes by reference: constant where the archive writes.
template <class Archive, class T>
using Archived = std::conditional_t<Archive::reads, T, const T>;

class ArchiveWriter {
 public:
  static constexpr bool reads = false;

  ArchiveWriter() = default;
  // Continues after bytes that are there already.
  explicit ArchiveWriter(std::vector<std::byte> before) : bytes_(std::move(before)) {}

  // Declares that so many bytes will be written from here on. Otherwise the writer takes up to three times their memory
  // while it grows.
  void expect(std::size_t bytes) { bytes_.reserve(bytes_.size() + bytes); }

  template <ArchivedNumber T>
  void operator()(T value) {
    numbers(std::span<const T>(&value, 1));
  }
  void operator()(bool value) { (*this)(std::uint8_t{value}); }
  void operator()(const std::string& text) {
    (*this)(std::uint64_t{text.size()});
    numbers(std::span<const char>(text));
  }

  // Writes the numbers without their count.
  template <ArchivedNumber T>
  void numbers(std::span<const T> values) {
    if (values.empty()) return;
    const std::size_t old_size = bytes_.size();
    bytes_.resize(old_size + values.size_bytes());
    std::memcpy(bytes_.data() + old_size, values.data(), values.size_bytes());
  }

  // Calls `element(*this, value)` for each.
  template <class T, class Element>
  void list(const std::vector<T>& values, const Element& element) {
    (*this)(std::uint64_t{values.size()});
    for (const T& value : values) element(*this, value);
  }

  std::span<const std::byte> bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

// Throws ArchiveError where the bytes end too early or a value is impossible, before allocating memory for it.
class ArchiveReader {
 public:
  static constexpr bool reads = true;

  explicit ArchiveReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <ArchivedNumber T>
  void operator()(T& value) {
    numbers(std::span<T>(&value, 1));
  }
  void operator()(bool& value) {
    std::uint8_t number = 0;
    (*this)(number);
    if (number > 1) throw ArchiveError("a flag is neither 0 nor 1");
    value = number == 1;
  }
  void operator()(std::string& text) {
    text.resize(count(1));
    numbers(std::span<char>(text));
  }

  template <ArchivedNumber T>
  void numbers(std::span<T> values) {
    const std::span<std::byte> wanted = std::as_writable_bytes(values);
    if (wanted.size() > bytes_.size()) throw ArchiveError("the data ends too early");
    if (!wanted.empty()) std::memcpy(wanted.data(), bytes_.data(), wanted.size());
    bytes_ = bytes_.subspan(wanted.size());
  }

  template <class T, class Element>
  void list(std::vector<T>& values, const Element& element) {
    values.resize(count(1));
    for (T& value : values) element(*this, value);
  }

  bool at_end() const { return bytes_.empty(); }

 private:
  // Reads the number of elements that take at least `bytes_each` bytes each.
  std::size_t count(std::size_t bytes_each) {
    std::uint64_t number = 0;
    (*this)(number);
    if (number > bytes_.size() / bytes_each) throw ArchiveError("a length exceeds the rest of the data");
    return static_cast<std::size_t>(number);
  }

  std::span<const std::byte> bytes_;
};

// One of the values of an enumeration, from 0 to `last`.
template <class Archive, class Enum>
void serialize_enum(Archive& archive, Enum& value, std::type_identity_t<Enum> last) {
  auto number = static_cast<std::uint8_t>(value);
  archive(number);
  if constexpr (Archive::reads) {
    if (number > static_cast<std::uint8_t>(last)) throw ArchiveError("there is no such choice");
    value = static_cast<Enum>(number);
  }
}

}  // namespace penumbra
