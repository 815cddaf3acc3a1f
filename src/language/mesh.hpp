// Mesh files: OBJ, and PLY as text or binary of either byte order. Only positions and faces are used. Nothing in a file
// can make the readers use more memory than a small multiple of its size.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/vec.hpp"
#include "language/diagnostic_list.hpp"
#include "language/file_bytes.hpp"
#include "scene/scene.hpp"

namespace penumbra {

struct MeshError {
  SourcePlace place;  // in the mesh file; line 0 for an error in binary data, whose byte `message` names
  std::string message;
};

// An error without a line.
MeshError mesh_error(std::string message);

// Appends the triangles of a mesh file, transformed by `matrix`, to `store`, which is unchanged if there is an error.
// The format is recognised by the start of the file, or by the end of its name.
std::optional<MeshError> read_mesh(const std::filesystem::path& path, FileBytes& bytes, const Affine& matrix,
                                   TriangleStore& store);

// The two formats.
std::optional<MeshError> read_obj(FileBytes& bytes, const Affine& matrix, TriangleStore& store);
std::optional<MeshError> read_ply(std::string_view bytes, const Affine& matrix, TriangleStore& store);

}  // namespace penumbra
