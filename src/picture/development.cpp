#include "picture/development.hpp"

#include <cstdlib>

#include "base/archive.hpp"

namespace penumbra {
namespace {

constexpr std::int64_t farthest_pixel = 1 << 30;

template <class Archive>
void serialize(Archive& archive, Archived<Archive, Development>& development) {
  archive(development.full_width);
  archive(development.full_height);
  archive.list(development.rects, [](auto& out, auto& rect) {
    for (auto* number : {&rect.x0, &rect.y0, &rect.x1, &rect.y1}) out(*number);
    for (auto* channel : {&rect.color.x, &rect.color.y, &rect.color.z}) out(*channel);
  });
  archive.list(development.metadata, [](auto& out, auto& entry) {
    out(entry.first);
    out(entry.second);
  });
  archive(development.exposure_halves);
  archive(development.bits);
  serialize_enum(archive, development.rounding, Rounding::course);
  if constexpr (Archive::reads) {
    const auto is_size = [](int side) { return side >= 1 && side <= most_side; };
    if (!is_size(development.full_width) || !is_size(development.full_height)) {
      throw ArchiveError("the size is out of range");
    }
    for (const PaintedRect& rect : development.rects) {
      for (const int number : {rect.x0, rect.y0, rect.x1, rect.y1}) {
        if (std::abs(std::int64_t{number}) > farthest_pixel) throw ArchiveError("a rectangle is out of range");
      }
    }
    if (std::abs(std::int64_t{development.exposure_halves}) > most_exposure_halves) {
      throw ArchiveError("the exposure is out of range");
    }
    if (development.bits != 8 && development.bits != 16) throw ArchiveError("the number of bits is neither 8 nor 16");
  }
}

}  // namespace

std::string to_bytes(const Development& development) {
  ArchiveWriter archive;
  serialize(archive, development);
  return {reinterpret_cast<const char*>(archive.bytes().data()), archive.bytes().size()};
}

Development development_from(const std::string& bytes) {
  Development development;
  ArchiveReader archive(std::as_bytes(std::span(bytes)));
  serialize(archive, development);
  if (!archive.at_end()) throw ArchiveError("it has more data than expected");
  return development;
}

}  // namespace penumbra
