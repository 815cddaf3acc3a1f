#include "language/object_tree.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace penumbra {
namespace {

Object group_object(Objects objects) {
  Object object;
  object.shape = std::make_shared<const Group>(Group{std::move(objects)});
  return object;
}

Object triangle_object(std::uint32_t first, std::uint32_t count, std::uint32_t surface) {
  Object object;
  object.shape = TriangleRange{first, count};
  object.surface = surface;
  return object;
}

}  // namespace

void ObjectTree::add(Object object, int nesting) {
  OpenGroup& group = groups_.back();
  group.objects.push_back(std::move(object));
  group.has_last = true;
  group.last_triangles = 0;
  group.nesting_before_last = group.nesting();
  group.nesting_of_last = nesting;
  objects_added_++;
}

void ObjectTree::add_polygon(std::uint32_t first, std::uint32_t count, std::uint32_t surface) {
  OpenGroup& group = groups_.back();
  if (group.has_last && group.last_triangles > 0) {
    Object& run = group.objects.back();
    auto& range = std::get<TriangleRange>(run.shape);
    if (run.surface == surface && run.motion == Vec3{} && range.first + range.count == first) {
      range.count += count;
      group.last_triangles = count;
      objects_added_++;
      return;
    }
  }
  add(triangle_object(first, count, surface));
  group.last_triangles = count;
}

Object& ObjectTree::last_object() {
  OpenGroup& group = groups_.back();
  if (group.last_triangles > 0) {
    Object& run = group.objects.back();
    auto& range = std::get<TriangleRange>(run.shape);
    if (range.count > group.last_triangles) {
      range.count -= group.last_triangles;
      const std::uint32_t first = range.first + range.count;
      const std::uint32_t surface = run.surface;
      group.objects.push_back(triangle_object(first, group.last_triangles, surface));
    }
  }
  return group.objects.back();
}

Object ObjectTree::take_last() {
  Object object = std::move(last_object());
  OpenGroup& group = groups_.back();
  group.objects.pop_back();
  group.has_last = false;
  group.last_triangles = 0;
  group.nesting_of_last = 0;
  return object;
}

void ObjectTree::open_group(std::string_view opener, const SourcePlace& place) {
  OpenGroup group;
  group.opener = opener;
  group.place = place;
  groups_.push_back(std::move(group));
}

void ObjectTree::close_group() {
  OpenGroup group = std::move(groups_.back());
  groups_.pop_back();
  group.objects.shrink_to_fit();
  const int nesting = group.nesting() + 1;
  add(group_object(std::move(group.objects)), nesting);
}

Group ObjectTree::snapshot() const {
  Objects inner;
  for (std::size_t level = groups_.size(); level-- > 0;) {
    Objects objects = groups_[level].objects;
    if (level + 1 < groups_.size()) objects.push_back(group_object(std::move(inner)));
    inner = std::move(objects);
  }
  return {std::move(inner)};
}

std::size_t ObjectTree::objects_to_copy() const {
  std::size_t count = 0;
  for (const OpenGroup& group : groups_) count += group.objects.size();
  return count;
}

}  // namespace penumbra
