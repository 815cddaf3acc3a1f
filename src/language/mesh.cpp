#include "language/mesh.hpp"

#include <strings.h>

namespace penumbra {
namespace {

bool is_ply(std::string_view bytes) { return bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 4) == "ply\r"; }

bool is_obj(const std::filesystem::path& path) { return ::strcasecmp(path.extension().c_str(), ".obj") == 0; }

std::optional<MeshError> read_any(const std::filesystem::path& path, FileBytes& bytes, MeshStore& mesh) {
  if (is_ply(bytes.view())) return read_ply(bytes.view(), mesh);
  if (is_obj(path)) return read_obj(bytes, mesh);
  return mesh_error("a mesh has to be an OBJ file (NAME.obj) or a PLY file (its first line is `ply`)");
}

}  // namespace

MeshError mesh_error(std::string message) { return {{}, std::move(message)}; }

MeshStore::MeshStore(TriangleStore& s, const Affine& m, bool is_flat)
    : store(s),
      matrix(m),
      flat(is_flat),
      first_vertex(s.vertices.size()),
      first_index(s.indices.size()),
      first_normal(s.normals.size()),
      first_normal_number(s.normal_numbers.size()) {}

void MeshStore::add_normal(Vec3 normal) {
  const Vec3 unit = normalize(transform_normal(matrix, normal));
  for (int axis = 0; axis < 3; axis++) store.normals.push_back(is_finite(unit) ? static_cast<float>(unit[axis]) : 0);
}

std::uint32_t MeshStore::normal_number(std::size_t i) const {
  const float* n = &store.normals[first_normal + 3 * i];
  return n[0] == 0 && n[1] == 0 && n[2] == 0 ? 0 : static_cast<std::uint32_t>(first_normal / 3 + i + 1);
}

void MeshStore::fill_normal_numbers() {
  store.normal_numbers.resize(first_normal_number + store.indices.size() - first_index, 0u);
}

void MeshStore::abandon() {
  store.vertices.resize(first_vertex);
  store.indices.resize(first_index);
  store.normals.resize(first_normal);
  store.normal_numbers.resize(first_normal_number);
}

std::optional<MeshError> read_mesh(const std::filesystem::path& path, FileBytes& bytes, MeshStore mesh) {
  std::optional<MeshError> error = read_any(path, bytes, mesh);
  if (error) {
    mesh.abandon();
    return error;
  }
  if (mesh.store.normal_numbers.size() > mesh.first_normal_number) mesh.fill_normal_numbers();
  if (determinant(mesh.matrix) < 0) mesh.store.turn_from(mesh.first_index, mesh.first_normal_number);
  return error;
}

}  // namespace penumbra
