#include "language/triangle_builder.hpp"

#include <limits>

namespace penumbra {
constexpr std::uint64_t largest_index = std::numeric_limits<std::uint32_t>::max();

void TriangleBuilder::start_file(const ReadProgress& progress) {
  progress_ = progress;
  vertices_at_start_ = store_->vertices.size();
  indices_at_start_ = store_->indices.size();
}

void TriangleBuilder::begin_polygon() {
  in_polygon_ = true;
  polygon_start_ = store_->vertices.size();
}

void TriangleBuilder::abandon_polygon() {
  in_polygon_ = false;
  store_->vertices.resize(polygon_start_);
}

std::uint32_t TriangleBuilder::end_polygon(bool mirrored) {
  in_polygon_ = false;
  const std::uint64_t first = polygon_start_ / 3;
  const std::uint64_t count = polygon_vertices() - 2;
  if (store_->vertices.size() / 3 > largest_index || store_->triangle_count() + count > largest_index) return 0;
  ZeroedVector<std::uint32_t>& indices = store_->indices;
  make_room(indices, 3 * count, progress_, indices_at_start_);
  for (std::uint64_t i = 0; i < count; i++) {
    indices.push_back(static_cast<std::uint32_t>(first));
    indices.push_back(static_cast<std::uint32_t>(first + i + 1));
    indices.push_back(static_cast<std::uint32_t>(first + i + 2));
  }
  if (mirrored) store_->turn_from(indices.size() - 3 * count);
  return static_cast<std::uint32_t>(count);
}

}  // namespace penumbra
