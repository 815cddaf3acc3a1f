// Writes the mesh of the mesh benchmarks, a sphere of 2 n (n - 1) triangles around (0, 0, -4) whose radius is modulated
// by products of sines, as binary PLY or as begin/vertex/end text; optionally with the two triangles of the ground.
// Usage: bumpy_sphere N FILE.ply|FILE.cli [ground]
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

namespace {

struct Vertex {
  float x, y, z;
};

Vertex vertex_at(int n, int row, int column) {
  const double polar = std::numbers::pi * row / n, around = 2 * std::numbers::pi * column / n;
  const double x = std::sin(polar) * std::cos(around), y = std::cos(polar), z = std::sin(polar) * std::sin(around);
  const double coarse = std::sin(9 * x + 2) * std::sin(11 * y) * std::sin(10 * z + 1);
  const double fine = std::sin(31 * x) * std::sin(29 * y + 1) * std::sin(33 * z);
  const double radius = 0.95 * (1 + 0.08 * (coarse + 0.4 * fine));
  return {static_cast<float>(radius * x), static_cast<float>(radius * y), static_cast<float>(radius * z - 4)};
}

constexpr Vertex ground[] = {{-40, -1, 10}, {40, -1, 10}, {40, -1, -60}, {-40, -1, -60}};

// `function` gets the indices of three vertices: those of the sphere, then those of the ground.
template <class Function>
void for_each_triangle(int n, bool has_ground, const Function& function) {
  for (int row = 0; row < n; row++) {
    for (int column = 0; column < n; column++) {
      const int here = row * n + column, right = row * n + (column + 1) % n;
      if (row > 0) function(here, right, here + n);
      if (row < n - 1) function(right, right + n, here + n);
    }
  }
  const int first = (n + 1) * n;
  if (has_ground) {
    function(first, first + 1, first + 2);
    function(first, first + 2, first + 3);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool has_ground = argc == 4 && std::string(argv[3]) == "ground";
  const bool is_usage = argc == 3 || has_ground;
  const int n = is_usage ? std::atoi(argv[1]) : 0;
  const std::string path = is_usage ? argv[2] : "";
  std::FILE* file = n >= 2 ? std::fopen(path.c_str(), "wb") : nullptr;
  if (file == nullptr) {
    std::fprintf(stderr, "usage: bumpy_sphere N FILE.ply|FILE.cli [ground]\n");
    return 64;
  }
  std::vector<Vertex> vertices;
  for (int row = 0; row <= n; row++) {
    for (int column = 0; column < n; column++) vertices.push_back(vertex_at(n, row, column));
  }
  if (has_ground) vertices.insert(vertices.end(), std::begin(ground), std::end(ground));
  if (path.ends_with(".ply")) {
    std::fprintf(file,
                 "ply\nformat binary_little_endian 1.0\nelement vertex %zu\nproperty float x\nproperty float y\n"
                 "property float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n",
                 vertices.size(), 2 * n * (n - 1) + (has_ground ? 2 : 0));
    std::fwrite(vertices.data(), sizeof(Vertex), vertices.size(), file);
    for_each_triangle(n, has_ground, [&](int a, int b, int c) {
      const std::int32_t corners[3] = {a, b, c};
      std::fputc(3, file);
      std::fwrite(corners, sizeof corners, 1, file);
    });
  } else {
    for_each_triangle(n, has_ground, [&](int a, int b, int c) {
      std::fputs("begin\n", file);
      for (const int corner : {a, b, c}) {
        const Vertex& v = vertices[static_cast<std::size_t>(corner)];
        std::fprintf(file, "vertex %.9g %.9g %.9g\n", v.x, v.y, v.z);
      }
      std::fputs("end\n", file);
    });
  }
  return std::fclose(file) == 0 ? 0 : 74;
}
