// What a scene is: plain data in double precision, no code that reads or renders.
//
// A scene is a tree of objects. Every object lives in the space of the group that contains it; the space of the root
// group is the world. Triangles and meshes are stored in bulk, with positions already in the space of their group; an
// object only names a range of triangles, so that ten million of them cost little more than their vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/vec.hpp"
#include "base/zeroed_pages.hpp"
#include "scene/light.hpp"
#include "scene/settings.hpp"

namespace penumbra {

struct Camera {
  double fov_degrees = 60;    // full angle over the shorter side of the picture, below 180
  Vec3 eye;                   // position in the world
  Vec3 right{1, 0, 0};        // u: to the right of the picture
  Vec3 up{0, 1, 0};           // v: to the top of the picture
  Vec3 back{0, 0, 1};         // w: the camera looks along -w
  double lens_radius = 0;     // world units; 0 is a pinhole
  double focus_distance = 1;  // distance of the plane in focus, along -w
  double focal_length = 0;    // F and n of `camera_lens`: the lens radius is F/(2n); 0 if unknown
  double f_number = 0;
  double shutter_open = 0;
  double shutter_close = 1;
};

enum class Texture : std::uint8_t { none, noise, wood, marble, stone };

struct Surface {
  Color diffuse{1, 1, 1};
  Color ambient;
  Color specular;
  double specular_power = 1;
  double reflection = 0;        // k_refl
  double gloss_radius = 0;      // radius of the ball added to the unit mirror direction
  double transmission = 0;      // k_trans
  double refraction_index = 1;  // inside; outside it is 1
  double blur_radius = 0;       // radius of the ball added to the unit refracted direction
  Highlight highlight = Highlight::blinn;
  bool open_highlight = false;  // made by a command that left the highlight to `highlight` and --highlight
  Texture texture = Texture::none;
  double texture_scale = 1;  // of `noise`

  bool operator==(const Surface&) const = default;
};

// What the objects of a kind are called, in singular and plural.
struct KindName {
  std::string_view one, several;
};

// Shapes in their own space; the object's `group_from_object` places them.
struct Sphere {
  static constexpr KindName name{"sphere", "spheres"};
  Vec3 center;
  double radius = 1;
};
struct Box {
  static constexpr KindName name{"box", "boxes"};
  Vec3 lo, hi;  // lo <= hi in every axis
};
struct Cylinder {  // along y
  static constexpr KindName name{"cylinder", "cylinders"};
  double radius = 1;
  double x = 0, z = 0;
  double y_min = 0, y_max = 1;
  bool capped = true;
};
struct Cone {  // along y, from its apex upwards, capped at the top
  static constexpr KindName name{"cone", "cones"};
  Vec3 apex;
  double height = 1;
  double slope = 1;  // radius for each unit of height
};

// `count` triangles of the TriangleStore from `first` on: a triangle, a polygon, a run of polygons, or a whole mesh
// file. Their positions are already in the space of the group; `group_from_object` is not applied to them.
struct TriangleRange {
  static constexpr KindName name{"triangle", "triangles"};
  static constexpr std::uint32_t flat = 0xffffffffu;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t normals = flat;  // of the first triangle in TriangleStore::normal_numbers, where vertices have normals
};

// Places a named object: group_from_object = M_instance * (the matrix that the object was defined with).
struct Instance {
  static constexpr KindName name{"instance", "instances"};
  std::uint32_t definition = 0;  // index into Scene::definitions
};

struct Group;

using Shape = std::variant<Sphere, Box, Cylinder, Cone, TriangleRange, std::shared_ptr<const Group>, Instance>;

// The kinds that are a single shape, whose parameters are all in the object.
template <typename Kind>
concept AnalyticShape = !std::is_same_v<Kind, TriangleRange> && !std::is_same_v<Kind, Instance> &&
                        !std::is_same_v<Kind, std::shared_ptr<const Group>>;

// One object of a group. Objects are in the order of the file: at equal distance, the first one wins.
struct Object {
  Shape shape;
  std::uint32_t surface = 0;    // index into Scene::surfaces; unused by groups and instances
  std::uint32_t placement = 0;  // index into Scene::placements: group_from_object; 0 is the identity
  Vec3 motion;                  // the object is shifted by time * motion, in the space of the group that contains it
};

using Objects = ZeroedVector<Object>;  // of a large scene, in large pages

struct Group {
  static constexpr KindName name{"group", "groups"};
  Objects objects;
};

inline KindName name_of(const Shape& shape) {
  const auto name = []<typename Kind>(const Kind&) {
    if constexpr (std::is_same_v<Kind, std::shared_ptr<const Group>>)
      return Group::name;
    else
      return Kind::name;
  };
  return std::visit(name, shape);
}

// All triangles of a scene, indexed, in the order of the file: corner k of triangle i is vertices[indices[3 i + k]].
// All pictures of one file share it: it only grows.
struct TriangleStore {
  ZeroedVector<float> vertices;         // 3 floats per vertex, in the space of the group of the triangle
  ZeroedVector<std::uint32_t> indices;  // 3 per triangle; its outward normal is (B-A)x(C-A)
  // Of meshes with vertex normals: unit vectors, and for the corners of each triangle the numbers of theirs, from 1.
  // Where these are 0, the triangle is flat.
  ZeroedVector<float> normals;
  ZeroedVector<std::uint32_t> normal_numbers;

  // Reverses the winding of all triangles from this index on. A mirroring matrix needs it to keep them outward.
  void turn_from(std::size_t first_index, std::size_t first_normal_number) {
    for (std::size_t i = first_index; i + 2 < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
    for (std::size_t i = first_normal_number; i + 2 < normal_numbers.size(); i += 3) {
      std::swap(normal_numbers[i + 1], normal_numbers[i + 2]);
    }
  }

  std::size_t triangle_count() const { return indices.size() / 3; }
};

struct Scene {
  Camera camera;
  Color background;
  Settings settings;

  std::vector<Light> lights;
  std::vector<Surface> surfaces;
  std::vector<Affine> placements{Affine{}};  // [0] is the identity
  std::shared_ptr<TriangleStore> triangles;  // never null in a scene that was read
  Objects definitions;                       // the named objects; an Instance refers to one by its index
  Group root;
};

}  // namespace penumbra
