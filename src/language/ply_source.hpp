// The data of a PLY file as a stream of numbers, from text or from bytes of either order. Both classes have the same
// functions, so that one reader serves both.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "language/number.hpp"
#include "language/ply_header.hpp"
#include "language/text_lines.hpp"

namespace penumbra {

template <class T>
T load_number(const char* p, bool swapped) {
  static_assert(sizeof(T) <= 8);
  char bytes[sizeof(T)];
  std::memcpy(bytes, p, sizeof(T));
  if (swapped) {
    for (std::size_t i = 0; i < sizeof(T) / 2; i++) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  }
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

class PlyBinary {
 public:
  PlyBinary(std::string_view bytes, std::size_t start, bool big_endian)
      : p_(bytes.data() + start),
        end_(bytes.data() + bytes.size()),
        swapped_(big_endian == (std::endian::native == std::endian::little)) {}

  static constexpr bool is_binary = true;
  static std::size_t least_size(PlyType type) { return size_of(type); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - p_); }
  const char* at() const { return p_; }
  bool swapped() const { return swapped_; }
  void advance(std::size_t bytes) { p_ += bytes; }

  // Reads the next number; false at the end of the data.
  bool read(PlyType type, double& value) {
    if (remaining() < size_of(type)) return false;
    switch (type) {
      case PlyType::int8:
        value = load_number<std::int8_t>(p_, swapped_);
        break;
      case PlyType::uint8:
        value = load_number<std::uint8_t>(p_, swapped_);
        break;
      case PlyType::int16:
        value = load_number<std::int16_t>(p_, swapped_);
        break;
      case PlyType::uint16:
        value = load_number<std::uint16_t>(p_, swapped_);
        break;
      case PlyType::int32:
        value = load_number<std::int32_t>(p_, swapped_);
        break;
      case PlyType::uint32:
        value = load_number<std::uint32_t>(p_, swapped_);
        break;
      case PlyType::float32:
        value = load_number<float>(p_, swapped_);
        break;
      case PlyType::float64:
        value = load_number<double>(p_, swapped_);
        break;
    }
    p_ += size_of(type);
    return true;
  }

  bool skip(PlyType type, std::uint64_t count) {
    if (remaining() / size_of(type) < count) return false;
    p_ += size_of(type) * count;
    return true;
  }

 private:
  const char* p_;
  const char* end_;
  bool swapped_;
};

class PlyText {
 public:
  PlyText(std::string_view bytes, std::size_t start) : p_(bytes.data() + start), end_(bytes.data() + bytes.size()) {}

  static constexpr bool is_binary = false;
  static std::size_t least_size(PlyType) { return 2; }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - p_) + 1; }
  const char* at() {
    skip_blanks();
    return p_;
  }

  // Reads the next number; false if there is none, and then stays in front of what is there instead.
  bool read(PlyType, double& value) {
    skip_blanks();
    const ParsedNumber parsed = parse_number(p_, end_, value);
    if (parsed.error != NumberError::none) return false;
    if (parsed.end != end_ && !is_space(*parsed.end)) return false;
    p_ = parsed.end;
    return true;
  }

  bool skip(PlyType, std::uint64_t count) {
    for (; count > 0; count--) {
      skip_blanks();
      if (p_ == end_) return false;
      while (p_ != end_ && !is_space(*p_)) p_++;
    }
    return true;
  }

 private:
  static bool is_space(char c) { return is_blank(c) || c == '\n'; }
  void skip_blanks() {
    while (p_ != end_ && is_space(*p_)) p_++;
  }

  const char* p_;
  const char* end_;
};

}  // namespace penumbra
