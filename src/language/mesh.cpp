#include "language/mesh.hpp"

#include <strings.h>

namespace penumbra {
namespace {

bool is_ply(std::string_view bytes) { return bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 4) == "ply\r"; }

bool is_obj(const std::filesystem::path& path) { return ::strcasecmp(path.extension().c_str(), ".obj") == 0; }

std::optional<MeshError> read_any(const std::filesystem::path& path, FileBytes& bytes, const Affine& matrix,
                                  TriangleStore& store) {
  if (is_ply(bytes.view())) return read_ply(bytes.view(), matrix, store);
  if (is_obj(path)) return read_obj(bytes, matrix, store);
  return mesh_error("a mesh has to be an OBJ file (NAME.obj) or a PLY file (its first line is `ply`)");
}

}  // namespace

MeshError mesh_error(std::string message) { return {{}, std::move(message)}; }

std::optional<MeshError> read_mesh(const std::filesystem::path& path, FileBytes& bytes, const Affine& matrix,
                                   TriangleStore& store) {
  const std::size_t vertices = store.vertices.size();
  const std::size_t indices = store.indices.size();
  std::optional<MeshError> error = read_any(path, bytes, matrix, store);
  if (error) {
    store.vertices.resize(vertices);
    store.indices.resize(indices);
  } else if (determinant(matrix) < 0) {
    store.turn_from(indices);
  }
  return error;
}

}  // namespace penumbra
