#include "rendering/sealed_file.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <cstring>
#include <utility>

#include "base/content_hash.hpp"

namespace penumbra {
namespace {

constexpr std::string_view magic = "PENUMBRA";
constexpr std::uint32_t format =
    4;  // 1: tiles of 16 pixels everywhere; 2: sums in another order; 3: no samples that are not finite
constexpr std::size_t head_size = 16, block_head_size = 16;

#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
constexpr bool checks_checksums = false;  // a fuzzer would never find a right one
#else
constexpr bool checks_checksums = true;
#endif

}  // namespace

const char* name_of(FileKind kind) { return kind == FileKind::checkpoint ? "checkpoint" : "part of a picture"; }

SealedWriter::SealedWriter(FileKind kind, std::vector<std::byte> before) : out_(std::move(before)) {
  out_.numbers(std::span(magic));
  out_(static_cast<std::uint32_t>(kind));
  out_(format);
}

void SealedWriter::expect(std::size_t blocks, std::size_t bytes_each) {
  constexpr std::size_t for_larger_ones = std::size_t{1} << 20;
  out_.expect((blocks + 1) * (bytes_each + block_head_size) + for_larger_ones);
}

void SealedWriter::add(std::span<const std::byte> block) {
  if (!block.empty()) write(block);
}

std::vector<std::byte> SealedWriter::finish() {
  write({});
  return out_.take();
}

void SealedWriter::write(std::span<const std::byte> block) {
  out_(std::uint64_t{block.size()});
  out_(checksum(block, number_++));
  out_.numbers(std::span(reinterpret_cast<const unsigned char*>(block.data()), block.size()));
}

bool is_sealed(std::span<const std::byte> bytes, FileKind kind) {
  if (bytes.size() < head_size || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) return false;
  std::uint32_t found = 0;
  ArchiveReader head(bytes.subspan(magic.size()));
  head(found);
  return found == static_cast<std::uint32_t>(kind);
}

SealedReader::SealedReader(std::span<const std::byte> bytes, FileKind kind, std::string name)
    : bytes_(bytes), kind_(kind), name_(std::move(name)), position_(head_size) {
  if (!is_sealed(bytes, kind)) throw FileError(EX_DATAERR, fmt::format("`{}` is not a {}", name_, name_of(kind)));
  std::uint32_t format_found = 0;
  ArchiveReader head(bytes.subspan(head_size - sizeof format_found));
  head(format_found);
  if (format_found != format) {
    throw FileError(EX_DATAERR, fmt::format("`{}` is a {} of format {}, but this program knows only format {}", name_,
                                            name_of(kind), format_found, format));
  }
}

std::span<const std::byte> SealedReader::next() {
  block_start_ = position_;
  number_++;
  const std::size_t left = bytes_.size() - position_;
  std::uint64_t length = 0, seal = 0;
  if (left < block_head_size) fail("the file ends too early");
  ArchiveReader head(bytes_.subspan(position_, block_head_size));
  head(length);
  head(seal);
  if (length > left - block_head_size) fail("the file ends too early");
  const auto block = bytes_.subspan(position_ + block_head_size, static_cast<std::size_t>(length));
  if (checks_checksums && seal != checksum(block, number_ - 1)) fail("its checksum does not match");
  position_ += block_head_size + block.size();
  if (block.empty() && position_ != bytes_.size()) fail("the file continues after its end");
  return block;
}

void SealedReader::fail(const std::string& why) const {
  throw FileError(EX_DATAERR, fmt::format("`{}` is a damaged {}: block {} at byte {} of {}: {}", name_, name_of(kind_),
                                          number_, block_start_, bytes_.size(), why));
}

}  // namespace penumbra
