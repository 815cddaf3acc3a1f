// Mesh files from arbitrary bytes, as OBJ unless they begin like PLY.
#include <cstdint>
#include <string>

#include "invariants.hpp"
#include "language/mesh.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  FileBytes bytes(std::string(reinterpret_cast<const char*>(data), size));
  TriangleStore store;
  store.vertices = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  store.indices = {0, 1, 2};
  const Affine matrix = scaling({2, 1, 1});
  const std::optional<MeshError> error = read_mesh("m.obj", bytes, MeshStore(store, matrix, false));
  require_sound(store);
  if (error) {
    require(store.vertices.size() == 9 && store.indices.size() == 3 && !error->message.empty());
    require(store.normals.empty() && store.normal_numbers.empty());
  } else {
    require(store.indices.size() > 3);
    require(store.normal_numbers.empty() || store.normal_numbers.size() == store.indices.size() - 3);
  }
  for (std::size_t i = 3; i < store.indices.size(); i++) require(store.indices[i] >= 3);
  return 0;
}
