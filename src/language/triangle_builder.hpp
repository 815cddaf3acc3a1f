// Fills the triangle store of a scene: polygons vertex by vertex, and room for whole meshes. Memory grows by what the
// unread part of the file will probably need, not by doubling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace penumbra {

// How much of the current file has been read, in bytes.
struct ReadProgress {
  std::size_t done = 0;
  std::size_t total = 0;
};

// Makes room for `extra` more elements, and for those that the rest of the file adds if it is like the part already
// read, in which the vector grew from `size_at_start`.
template <class T>
void make_room(ZeroedVector<T>& vector, std::size_t extra, const ReadProgress& progress, std::size_t size_at_start) {
  const std::size_t needed = vector.size() + extra;
  if (needed <= vector.capacity()) return;
  constexpr std::size_t enough_to_judge = std::size_t{1} << 16;
  std::size_t room = needed + needed / 2;
  if (progress.done >= enough_to_judge && vector.size() > size_at_start) {
    const double per_byte = static_cast<double>(needed - size_at_start) / static_cast<double>(progress.done);
    const double rest = 1.02 * per_byte * static_cast<double>(progress.total - progress.done);
    room = needed + needed / 16 + static_cast<std::size_t>(rest);
  }
  vector.reserve(room);
}

// Whether a position can be stored in single precision.
inline bool fits_single_precision(Vec3 p) {
  constexpr double largest = std::numeric_limits<float>::max();
  return std::abs(p.x) <= largest && std::abs(p.y) <= largest && std::abs(p.z) <= largest;
}

class TriangleBuilder {
 public:
  TriangleBuilder() : store_(std::make_shared<TriangleStore>()) {}

  const std::shared_ptr<TriangleStore>& store() const { return store_; }
  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(store_->triangle_count()); }

  // A new file begins, or an outer one resumes.
  void start_file(const ReadProgress& progress);
  ReadProgress& progress() { return progress_; }

  bool in_polygon() const { return in_polygon_; }
  void begin_polygon();
  void abandon_polygon();
  // Adds a corner. False if it does not fit single precision.
  bool add_vertex(Vec3 position) {
    if (!fits_single_precision(position)) return false;
    ZeroedVector<float>& vertices = store_->vertices;
    make_room(vertices, 3, progress_, vertices_at_start_);
    vertices.push_back(static_cast<float>(position.x));
    vertices.push_back(static_cast<float>(position.y));
    vertices.push_back(static_cast<float>(position.z));
    return true;
  }
  std::uint64_t polygon_vertices() const { return (store_->vertices.size() - polygon_start_) / 3; }
  // Splits the open polygon, which has at least three corners, into triangles. Returns what is wrong, if anything. With
  // `mirrored`, for a matrix that mirrors, the winding is reversed, which keeps the outward side outward.
  std::string end_polygon(bool mirrored);

 private:
  std::shared_ptr<TriangleStore> store_;
  ReadProgress progress_;
  std::size_t vertices_at_start_ = 0;
  std::size_t indices_at_start_ = 0;
  std::size_t polygon_start_ = 0;
  std::vector<std::uint32_t> corners_;  // of the last polygon
  bool in_polygon_ = false;
};

}  // namespace penumbra
