#include "language/scene_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace penumbra {
namespace {

// How far back an equal surface is searched for.
constexpr std::size_t surfaces_to_compare = 8;

bool fits_single_precision(const Affine& m) {
  for (const Vec3& column : m.column) {
    if (!penumbra::fits_single_precision(column)) return false;
  }
  return penumbra::fits_single_precision(m.translation);
}

}  // namespace

SceneBuilder::SceneBuilder(const Limits& limits) : limits_(limits) { scene_.triangles = triangles_.store(); }

Scene& SceneBuilder::change() {
  if (!waiting_.empty()) {
    Scene copy = scene_;
    copy.root = tree_.snapshot();
    copied_ += size_of_copy();
    share_with_pictures(std::move(copy));
  }
  return scene_;
}

void SceneBuilder::share_with_pictures(Scene scene) {
  const auto shared = std::make_shared<const Scene>(std::move(scene));
  for (const std::size_t i : waiting_) std::get<Picture>(actions_[i]).scene = shared;
  waiting_.clear();
}

std::size_t SceneBuilder::size_of_copy() const {
  return tree_.objects_to_copy() + scene_.lights.size() + scene_.surfaces.size() + scene_.placements.size() +
         scene_.definitions.size();
}

void SceneBuilder::set_matrix(const Affine& matrix) {
  matrix_ = matrix;
  matrix_checked_ = false;
  placement_index_.reset();
}

Problem SceneBuilder::push(const SourcePlace& place) {
  if (pushed_.size() >= limits_.pushes) return fmt::format("more than {} `push` are open", limits_.pushes);
  pushed_.emplace_back(matrix_, place);
  return {};
}

Problem SceneBuilder::pop() {
  if (pushed_.empty()) return "`pop` without a `push` before it";
  set_matrix(pushed_.back().first);
  pushed_.pop_back();
  return {};
}

Problem SceneBuilder::check_matrix() {
  if (matrix_checked_) return {};
  const double size = determinant(matrix_);
  if (!fits_single_precision(matrix_) || !std::isfinite(size)) return "the current matrix has become too large";
  if (size == 0 || !fits_single_precision(inverse(matrix_))) {
    return "the current matrix is singular: it flattens the shape, or shrinks it to nothing";
  }
  matrix_checked_ = true;
  return {};
}

void SceneBuilder::set_surface(const Surface& surface, const MadeBy& by) {
  change_surface() = surface;
  surface_by_ = by;
}

void SceneBuilder::add_light(const Light& light, const MadeBy& by) {
  change().lights.push_back(light);
  light_makers_.push_back(by);
}

std::uint32_t SceneBuilder::surface_index() {
  if (surface_index_) return *surface_index_;
  std::vector<Surface>& surfaces = scene_.surfaces;
  const std::size_t compared = std::min(surfaces.size(), surfaces_to_compare);
  const auto equal = std::find(surfaces.rbegin(), surfaces.rbegin() + static_cast<std::ptrdiff_t>(compared), surface_);
  auto back = static_cast<std::size_t>(equal - surfaces.rbegin());
  if (back == compared) {
    surfaces.push_back(surface_);
    surface_makers_.push_back(surface_by_);
    back = 0;
  }
  surface_index_ = static_cast<std::uint32_t>(surfaces.size() - 1 - back);
  return *surface_index_;
}

std::uint32_t SceneBuilder::placement_index() {
  if (placement_index_) return *placement_index_;
  std::vector<Affine>& placements = scene_.placements;
  const bool is_identity = matrix_ == placements.front();
  if (!is_identity && !(matrix_ == placements.back())) placements.push_back(matrix_);
  placement_index_ = is_identity ? 0 : static_cast<std::uint32_t>(placements.size() - 1);
  return *placement_index_;
}

Problem SceneBuilder::add_shape(Shape shape, Vec3 motion, bool placed) {
  Problem wrong = placed ? check_matrix() : Problem();
  if (!wrong.empty()) return wrong;
  if (!penumbra::fits_single_precision(motion)) return "the motion has become too large";
  change();
  const std::uint32_t surface = surface_index();
  tree_.add({std::move(shape), surface, placed ? placement_index() : 0, motion});
  return {};
}

Problem SceneBuilder::add_mesh(std::uint32_t first, std::size_t first_normal_number) {
  TriangleRange range{first, triangles_.triangle_count() - first};
  const bool smooth = triangles_.store()->normal_numbers.size() > first_normal_number;
  if (smooth) range.normals = static_cast<std::uint32_t>(first_normal_number / 3);
  return range.count == 0 ? Problem() : add_shape(range, {}, false);
}

Problem SceneBuilder::begin_polygon(const SourcePlace& place) {
  if (Problem wrong = check_matrix(); !wrong.empty()) return wrong;
  polygon_place_ = place;
  triangles_.begin_polygon();
  return {};
}

Problem SceneBuilder::end_polygon() {
  const std::uint64_t corners = triangles_.polygon_vertices();
  if (corners < 3) {
    triangles_.abandon_polygon();
    return fmt::format("a polygon needs at least three `vertex` lines; found {}", corners);
  }
  const std::uint32_t first = triangles_.triangle_count();
  change();
  if (Problem wrong = triangles_.end_polygon(determinant(matrix()) < 0); !wrong.empty()) return wrong;
  tree_.add_polygon(first, triangles_.triangle_count() - first, surface_index());
  return {};
}

Problem SceneBuilder::open_group(std::string_view opener, const SourcePlace& place) {
  if (tree_.open_groups() >= limits_.nesting) return fmt::format("groups nest more than {} deep", limits_.nesting);
  change();
  tree_.open_group(opener, place);
  return {};
}

void SceneBuilder::close_group() {
  change();
  tree_.close_group();
}

Problem SceneBuilder::name_last(std::string_view name, const SourcePlace& place) {
  if (!tree_.has_last()) return "there is no object before it to name";
  change();
  NamedObject named;
  named.definition = static_cast<std::uint32_t>(scene_.definitions.size());
  named.nesting = tree_.nesting_of_last();
  named.place = place;
  scene_.definitions.push_back(tree_.take_last());
  tree_.names.emplace(name, std::move(named));
  return {};
}

Problem SceneBuilder::add_instance(std::string_view name) {
  NamedObject& named = tree_.names.find(name)->second;
  named.used = true;
  if (Problem wrong = check_matrix(); !wrong.empty()) return wrong;
  if (named.nesting >= limits_.nesting) {
    return fmt::format("groups and instances nest more than {} deep", limits_.nesting);
  }
  change();
  Object object;
  object.shape = Instance{named.definition};
  object.placement = placement_index();
  tree_.add(std::move(object), named.nesting + 1);
  return {};
}

Problem SceneBuilder::move_last(Vec3 motion) {
  if (!tree_.has_last()) return "there is no object before it to move";
  change();
  Object& object = tree_.last_object();
  const Vec3 sum = object.motion + motion;
  if (!penumbra::fits_single_precision(sum)) return "the motion has become too large";
  object.motion = sum;
  return {};
}

Problem SceneBuilder::add_picture(std::string file, TopicPlaces places) {
  if (waiting_.empty() && pictures_ > 0 && copied_ + size_of_copy() > limits_.copies) {
    return "too many pictures of too many objects in one file";
  }
  last_picture_ = actions_.size();
  waiting_.push_back(last_picture_);
  actions_.emplace_back(Picture{std::move(file), nullptr, std::move(rects_), std::move(places)});
  rects_.clear();
  pictures_++;
  return {};
}

std::vector<Action> SceneBuilder::take_actions() {
  if (!waiting_.empty()) {
    scene_.root = tree_.take();
    share_with_pictures(std::move(scene_));
  }
  return std::move(actions_);
}

}  // namespace penumbra
