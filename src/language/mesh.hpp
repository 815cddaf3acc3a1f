// Mesh files: OBJ, and PLY as text or binary of either byte order. Positions, faces and vertex normals are used.
// Nothing in a file can make the readers use more memory than a small multiple of its size.
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

// The mesh that is being read: its triangles follow those that the store has already.
class MeshStore {
 public:
  // `flat`: normals are left out.
  MeshStore(TriangleStore& store, const Affine& matrix, bool flat);

  TriangleStore& store;
  const Affine& matrix;
  const bool flat;
  const std::size_t first_vertex, first_index, first_normal, first_normal_number;  // sizes of the store before

  std::size_t normal_count() const { return (store.normals.size() - first_normal) / 3; }
  // Adds a normal as the file has it. One that is zero or not finite leaves its faces flat.
  void add_normal(Vec3 normal);
  // The number of a normal of this mesh, counted from 0, in the store; 0 if it leaves its faces flat.
  std::uint32_t normal_number(std::size_t i) const;
  // The triangles so far that have no normals become flat.
  void fill_normal_numbers();
  // Forgets all of the mesh.
  void abandon();
};

// Appends the triangles of a mesh file to the store, which is unchanged if there is an error. The format is recognised
// by the start of the file, or by the end of its name.
std::optional<MeshError> read_mesh(const std::filesystem::path& path, FileBytes& bytes, MeshStore mesh);

// The two formats.
std::optional<MeshError> read_obj(FileBytes& bytes, MeshStore& mesh);
std::optional<MeshError> read_ply(std::string_view bytes, MeshStore& mesh);

}  // namespace penumbra
