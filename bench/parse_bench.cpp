// How fast scenes are read, in MB/s on one core: a mesh of about 100 MB as begin/vertex/end text, as binary PLY of both
// byte orders, as text PLY and as OBJ; and as many spheres. Writes its inputs below the folder for temporary files and
// removes them. Usage: parse_bench [MEGABYTES]
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "language/scene_file.hpp"

namespace {

namespace fs = std::filesystem;

struct Vertex {
  float x, y, z;
};

// A wavy sheet of n x n quads.
struct Sheet {
  int n;
  Vertex at(int i, int j) const {
    const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
    return {static_cast<float>(u * 2 - 1), static_cast<float>(0.1 * std::sin(40 * u) * std::cos(37 * v)),
            static_cast<float>(-4 - 2 * v)};
  }
  template <class Function>
  void for_each_triangle(Function&& function) const {
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        const int a = i * (n + 1) + j, b = a + n + 1;
        function(a, a + 1, b);
        function(a + 1, b + 1, b);
      }
    }
  }
  Vertex vertex(int index) const { return at(index / (n + 1), index % (n + 1)); }
  int vertices() const { return (n + 1) * (n + 1); }
  int triangles() const { return 2 * n * n; }
};

// Buffers what is written, so that many small writes are fast.
class Output {
 public:
  explicit Output(const fs::path& path) : file_(path, std::ios::binary) {}
  ~Output() { flush(); }
  template <class... Arguments>
  void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
    if (buffer_.size() > (1 << 20)) flush();
  }
  template <class T>
  void binary(T value, bool swapped) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (swapped) std::reverse(bytes, bytes + sizeof(T));
    buffer_.append(bytes, sizeof(T));
    if (buffer_.size() > (1 << 20)) flush();
  }

 private:
  void flush() {
    file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }
  std::ofstream file_;
  std::string buffer_;
};

void write_text(const Sheet& sheet, const fs::path& path) {
  Output out(path);
  out.print("point_light 0 5 0 1 1 1\n");
  sheet.for_each_triangle([&](int a, int b, int c) {
    out.print("begin\n");
    for (const int k : {a, b, c}) {
      const Vertex v = sheet.vertex(k);
      out.print("vertex {:.6f} {:.6f} {:.6f}\n", v.x, v.y, v.z);
    }
    out.print("end\n");
  });
}

// A sphere at each vertex.
void write_spheres(const Sheet& sheet, const fs::path& path) {
  Output out(path);
  out.print("point_light 0 5 0 1 1 1\n");
  for (int k = 0; k < sheet.vertices(); k++) {
    const Vertex v = sheet.vertex(k);
    out.print("sphere {:.6f} {:.6f} {:.6f} {:.6f}\n", 1.0 / sheet.n, v.x, v.y, v.z);
  }
}

void write_obj(const Sheet& sheet, const fs::path& path) {
  Output out(path);
  for (int k = 0; k < sheet.vertices(); k++) {
    const Vertex v = sheet.vertex(k);
    out.print("v {:.6f} {:.6f} {:.6f}\n", v.x, v.y, v.z);
  }
  sheet.for_each_triangle([&](int a, int b, int c) { out.print("f {} {} {}\n", a + 1, b + 1, c + 1); });
}

void write_ply(const Sheet& sheet, const fs::path& path, std::string_view format) {
  Output out(path);
  out.print("ply\nformat {} 1.0\nelement vertex {}\n", format, sheet.vertices());
  out.print("property float x\nproperty float y\nproperty float z\nelement face {}\n", sheet.triangles());
  out.print("property list uchar int vertex_indices\nend_header\n");
  const bool text = format == "ascii";
  const bool swapped = format == "binary_big_endian";
  for (int k = 0; k < sheet.vertices(); k++) {
    const Vertex v = sheet.vertex(k);
    if (text) {
      out.print("{:.6f} {:.6f} {:.6f}\n", v.x, v.y, v.z);
    } else {
      for (const float value : {v.x, v.y, v.z}) out.binary(value, swapped);
    }
  }
  sheet.for_each_triangle([&](int a, int b, int c) {
    if (text) return out.print("3 {} {} {}\n", a, b, c);
    out.binary(std::uint8_t{3}, false);
    for (const int k : {a, b, c}) out.binary(k, swapped);
  });
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

// Reads the scene a few times; the best time counts.
void measure(const std::string& what, const fs::path& scene, const fs::path& data) {
  double best = 1e30;
  std::size_t shapes = 0;
  for (int run = 0; run < 4; run++) {
    const auto start = std::chrono::steady_clock::now();
    const penumbra::SceneFile file = penumbra::read_scene(scene, {});
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    for (const penumbra::Diagnostic& d : file.diagnostics) {
      if (d.severity == penumbra::Severity::error) fmt::print("{}", penumbra::to_string(d));
    }
    if (file.actions.empty()) return;
    const penumbra::Scene& read = *std::get<penumbra::Picture>(file.actions.front()).scene;
    shapes = std::max(read.triangles->triangle_count(), read.root.objects.size());
  }
  const double megabytes = static_cast<double>(fs::file_size(data)) / 1e6;
  fmt::print("{:<24} {:7.1f} MB {:8.3f} s {:8.0f} MB/s {:10} shapes {:6.1f} ns each, peak so far {:.0f} MB\n", what,
             megabytes, best, megabytes / best, shapes, 1e9 * best / static_cast<double>(shapes), peak_megabytes());
  std::fflush(stdout);
}

void measure_mesh(const std::string& what, const fs::path& mesh) {
  const fs::path scene = mesh.string() + ".cli";
  std::ofstream(scene) << "point_light 0 5 0 1 1 1\nmesh " << mesh.filename().string() << '\n';
  measure(what, scene, mesh);
}

}  // namespace

int main(int argc, char** argv) {
  const double megabytes = argc > 1 ? std::atof(argv[1]) : 100;
  const fs::path folder = fs::temp_directory_path() / fmt::format("penumbra-parse-bench-{}", ::getpid());
  fs::create_directories(folder);
  const Sheet text{std::max(2, static_cast<int>(std::sqrt(megabytes * 1e6 / 107 / 2)))};
  const Sheet mesh{std::max(2, static_cast<int>(std::sqrt(megabytes * 1e6 / 38)))};

  write_text(text, folder / "text.cli");
  measure("begin/vertex/end", folder / "text.cli", folder / "text.cli");
  fs::remove(folder / "text.cli");
  write_spheres({std::max(2, static_cast<int>(std::sqrt(megabytes * 1e6 / 43)))}, folder / "spheres.cli");
  measure("spheres", folder / "spheres.cli", folder / "spheres.cli");
  fs::remove(folder / "spheres.cli");
  for (const char* format : {"binary_little_endian", "binary_big_endian", "ascii"}) {
    write_ply(mesh, folder / "mesh.ply", format);
    measure_mesh(std::string("PLY ") + format, folder / "mesh.ply");
  }
  write_obj(mesh, folder / "mesh.obj");
  measure_mesh("OBJ", folder / "mesh.obj");
  fs::remove_all(folder);
  return 0;
}
