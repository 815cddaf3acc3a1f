// The scene while it is read, and the pictures taken of it. Knows the rules of the language but nothing of its text: an
// error is a sentence to which the caller adds the place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language/file_bytes.hpp"
#include "language/object_tree.hpp"
#include "language/scene_file.hpp"
#include "language/triangle_builder.hpp"
#include "scene/scene.hpp"

namespace penumbra {

// What is wrong, as a sentence without a full stop; empty if nothing is.
using Problem = std::string;

// Limits that keep any input, however contrived, from exhausting the machine.
struct Limits {
  std::size_t open_files = 64;                // open at once, each read by the one before
  std::size_t reads = 65'536;                 // files opened in total
  std::uint64_t bytes = most_bytes_read;      // read in total
  std::size_t copies = std::size_t{1} << 23;  // objects, lights and the like copied for pictures, in total
  std::size_t pushes = 4'096;                 // `push` still without its `pop`
  int nesting = 64;                           // levels of groups and instances
};

// The command that made a light or a surface.
struct MadeBy {
  std::string_view command;
  std::uint32_t visit = 0;
  std::int64_t line = 0;
};

class SceneBuilder {
 public:
  explicit SceneBuilder(const Limits& limits);

  const Scene& scene() const { return scene_; }
  // The scene, for changing: pictures already taken keep it as it was.
  Scene& change();

  // The current matrix.
  const Affine& matrix() const { return matrix_; }
  void set_matrix(const Affine& matrix);
  // Why no shape can be placed under it; empty if one can.
  Problem check_matrix();
  Problem push(const SourcePlace& place);
  Problem pop();
  const std::vector<std::pair<Affine, SourcePlace>>& pushed() const { return pushed_; }

  // The current surface.
  const Surface& surface() const { return surface_; }
  Surface& change_surface() {
    surface_index_.reset();
    return surface_;
  }
  void set_surface(const Surface& surface, const MadeBy& by);

  void add_light(const Light& light, const MadeBy& by);
  // Who made the lights and surfaces of the scene, in its order.
  const std::vector<MadeBy>& light_makers() const { return light_makers_; }
  const std::vector<MadeBy>& surface_makers() const { return surface_makers_; }

  // Adds a shape under the current matrix or, if it is not to be `placed`, under none; `motion` is in the space of the
  // open group.
  Problem add_shape(Shape shape, Vec3 motion = {}, bool placed = true);
  // Adds the triangles from `first` to the end of the store as one object, and the numbers of their normals likewise.
  Problem add_mesh(std::uint32_t first, std::size_t first_normal_number);

  // Polygons.
  bool in_polygon() const { return triangles_.in_polygon(); }
  Problem begin_polygon(const SourcePlace& place);
  bool add_vertex(Vec3 position) { return triangles_.add_vertex(transform_point(matrix_, position)); }
  Problem end_polygon();
  const SourcePlace& polygon_place() const { return polygon_place_; }
  TriangleBuilder& triangles() { return triangles_; }

  // Groups, names, motion.
  Problem open_group(std::string_view opener, const SourcePlace& place);
  void close_group();
  Problem name_last(std::string_view name, const SourcePlace& place);
  Problem add_instance(std::string_view name);
  Problem move_last(Vec3 motion);
  ObjectTree& tree() { return tree_; }
  const ObjectTree& tree() const { return tree_; }

  // Pictures, timers and painted rectangles.
  Problem add_picture(std::string file, TopicPlaces places);
  void add_timer(const Action& action) { actions_.push_back(action); }
  void set_paint(Color color) { paint_ = color; }
  void add_rect(int x0, int y0, int x1, int y1) { rects_.push_back({x0, y0, x1, y1, paint_}); }
  std::size_t rects() const { return rects_.size(); }
  std::size_t pictures() const { return pictures_; }
  // The picture taken last; there must be one.
  const Picture& last_picture() const { return std::get<Picture>(actions_[last_picture_]); }
  // All pictures and timers, in order; the builder is empty afterwards.
  std::vector<Action> take_actions();

 private:
  std::uint32_t surface_index();
  std::uint32_t placement_index();
  std::size_t size_of_copy() const;
  void share_with_pictures(Scene scene);

  Limits limits_;
  Scene scene_;  // its root is filled when a picture takes it
  ObjectTree tree_;
  TriangleBuilder triangles_;

  Affine matrix_;
  bool matrix_checked_ = true;
  std::vector<std::pair<Affine, SourcePlace>> pushed_;
  std::optional<std::uint32_t> placement_index_;  // of the matrix, once a shape was placed under it
  Surface surface_;
  std::optional<std::uint32_t> surface_index_;  // of the surface, once a shape had it
  MadeBy surface_by_;
  std::vector<MadeBy> light_makers_, surface_makers_;
  SourcePlace polygon_place_;

  std::vector<Action> actions_;
  std::vector<std::size_t> waiting_;  // pictures of the scene as it stands; it is copied only when it changes
  std::size_t pictures_ = 0;
  std::size_t last_picture_ = 0;
  std::size_t copied_ = 0;
  std::vector<PaintedRect> rects_;
  Color paint_{1, 1, 1};
};

}  // namespace penumbra
