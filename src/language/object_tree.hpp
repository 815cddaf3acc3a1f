// The objects of a scene while it is read: the open groups, the last object, the named objects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "language/diagnostic_list.hpp"
#include "scene/scene.hpp"

namespace penumbra {

// A group whose end has not been read yet. The first one is the scene itself.
struct OpenGroup {
  Objects objects;
  std::string opener;  // the command that opened it
  SourcePlace place;

  bool has_last = false;
  std::uint32_t last_triangles = 0;  // of the last polygon, in the run objects.back(); 0 if that is not a run
  int nesting_before_last = 0;       // levels of groups and instances in the objects before the last one
  int nesting_of_last = 0;

  int nesting() const { return std::max(nesting_before_last, nesting_of_last); }
};

struct NamedObject {
  std::uint32_t definition = 0;  // index into Scene::definitions
  int nesting = 0;
  bool used = false;
  SourcePlace place;
};

class ObjectTree {
 public:
  ObjectTree() : groups_(1) {}

  // Adds an object that contains `nesting` levels of groups and instances.
  void add(Object object, int nesting = 0);

  // Adds a polygon: the triangles [first, first + count) of the store. It joins the run of the polygon before it if it
  // can, but remains a separate object for last_object().
  void add_polygon(std::uint32_t first, std::uint32_t count, std::uint32_t surface);

  bool has_last() const { return groups_.back().has_last; }
  // The last object, which must exist; if it is part of a run of polygons, it is split off first.
  Object& last_object();
  int nesting_of_last() const { return groups_.back().nesting_of_last; }
  // Removes the last object, which must exist, from its group.
  Object take_last();

  int open_groups() const { return static_cast<int>(groups_.size()) - 1; }
  const OpenGroup& innermost() const { return groups_.back(); }
  const OpenGroup& group(int level) const { return groups_[static_cast<std::size_t>(level)]; }
  void open_group(std::string_view opener, const SourcePlace& place);
  // Makes the innermost group, which must not be the scene, an object of the group around it.
  void close_group();

  // The objects as they stand now, open groups included.
  Group snapshot() const;
  Group take() { return {std::move(groups_.front().objects)}; }

  // The number of objects that a snapshot copies.
  std::size_t objects_to_copy() const;
  // How many objects have been added so far.
  std::uint64_t objects_added() const { return objects_added_; }

  std::map<std::string, NamedObject, std::less<>> names;

 private:
  std::vector<OpenGroup> groups_;
  std::uint64_t objects_added_ = 0;
};

}  // namespace penumbra
