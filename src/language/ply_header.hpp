// The header of a PLY file: its elements, their properties, and where the data starts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language/mesh.hpp"

namespace penumbra {

enum class PlyFormat : std::uint8_t { ascii, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

inline std::size_t size_of(PlyType type) {
  constexpr std::size_t size[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return size[static_cast<std::size_t>(type)];
}
inline bool is_float(PlyType type) { return type == PlyType::float32 || type == PlyType::float64; }

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  // for a list, of its elements
  bool is_list = false;
  PlyType count_type = PlyType::uint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  // The index of the property of that name; -1 if there is none.
  int find(std::string_view property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  // in bytes; the data follows

  const PlyElement* find(std::string_view element) const;
};

// Reads the header of a file that starts with the line `ply`.
std::optional<MeshError> read_ply_header(std::string_view bytes, PlyHeader& header);

}  // namespace penumbra
