#include "language/triangle_builder.hpp"

#include <limits>
#include <numeric>

#include "language/polygon.hpp"

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

std::string TriangleBuilder::end_polygon(bool mirrored) {
  in_polygon_ = false;
  if (store_->vertices.size() / 3 > largest_index) return "there are too many vertices";
  const std::size_t first = store_->indices.size();
  make_room(store_->indices, 3 * (polygon_vertices() - 2), progress_, indices_at_start_);
  corners_.resize(polygon_vertices());
  std::iota(corners_.begin(), corners_.end(), static_cast<std::uint32_t>(polygon_start_ / 3));
  std::string problem = append_polygon(*store_, corners_);
  if (mirrored) store_->turn_from(first, store_->normal_numbers.size());
  return problem;
}

}  // namespace penumbra
