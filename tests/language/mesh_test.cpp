// OBJ and PLY files, valid and invalid.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "support.hpp"

namespace penumbra {
namespace {

const std::string tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

Scene mesh_scene(const std::string& name, const std::string& content, const std::string& before = "") {
  return scene_of(light + before + "mesh " + name + "\n", {}, {{name, content}});
}

std::string mesh_error(const std::string& name, const std::string& content) {
  return told("mesh " + name + "\n", {}, {{name, content}});
}

template <class T>
std::string bytes_of(T value, bool big_endian) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string ply_head(const std::string& format, int vertices, int faces, const std::string& position = "float",
                     const std::string& list = "uchar int") {
  return fmt::format(
      "ply\nformat {0} 1.0\ncomment made by hand\nelement vertex {1}\nproperty {3} x\nproperty {3} y\nproperty {3} z\n"
      "element face {2}\nproperty list {4} vertex_indices\nend_header\n",
      format, vertices, faces, position, list);
}

// A square of two triangles, or one quad.
template <class Position, class Count, class Index>
std::string binary_square(bool big, const std::string& position, const std::string& list, bool as_quad) {
  std::string data = ply_head(big ? "binary_big_endian" : "binary_little_endian", 4, as_quad ? 1 : 2, position, list);
  for (const double v : {0., 0., -4., 1., 0., -4., 1., 1., -4., 0., 1., -4.})
    data += bytes_of(static_cast<Position>(v), big);
  const std::vector<std::vector<int>> faces =
      as_quad ? std::vector<std::vector<int>>{{0, 1, 2, 3}} : std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}};
  for (const auto& face : faces) {
    data += bytes_of(static_cast<Count>(face.size()), big);
    for (const int i : face) data += bytes_of(static_cast<Index>(i), big);
  }
  return data;
}

void expect_square(const Scene& scene) {
  ASSERT_EQ(scene.triangles->indices, (ZeroedVector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(scene.triangles->vertices, (ZeroedVector<float>{0, 0, -4, 1, 0, -4, 1, 1, -4, 0, 1, -4}));
  ASSERT_EQ(scene.root.objects.size(), 1u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[0]).count, 2u);
}

TEST(Obj, isReadAsOneObject) {
  const Scene scene = mesh_scene("t.obj", tetrahedron_obj, "surface 1 0 0\ntranslate 0 0 -4\nscale 2 2 2\n");
  ASSERT_EQ(scene.root.objects.size(), 1u);
  EXPECT_EQ(shape_of<TriangleRange>(scene.root.objects[0]).count, 4u);
  EXPECT_EQ(scene.surfaces[scene.root.objects[0].surface].diffuse, (Vec3{1, 0, 0}));
  EXPECT_EQ(corners(scene, 0), (std::vector<Vec3>{{0, 0, -4}, {0, 2, -4}, {2, 0, -4}}));
  EXPECT_EQ(scene.triangles->vertices.size(), 12u) << "vertices are shared";
}

TEST(Obj, isReadWithAllThatIsIgnored) {
  const Scene scene =
      mesh_scene("t.OBJ",
                 "# a comment\r\nmtllib x.mtl\r\no thing\r\nv 0 0 0 1\r\nv 1 0 0 .5 .5 .5\r\nv 0 1 0\r\n"
                 "vt 0 0\r\nvn 0 0 1\r\ng all\r\ns off\r\nusemtl red\r\nf 1/1/1 2/1/1 3/1/1\r\nl 1 2\r\n"
                 "f 1//1 2//1 3//1\r\nf -3 -2 -1 # backwards");
  EXPECT_EQ(scene.triangles->indices, (ZeroedVector<std::uint32_t>{0, 1, 2, 0, 1, 2, 0, 1, 2}));
}

TEST(Obj, splitsPolygonsAndGoesOnBehindABackslash) {
  const Scene scene = mesh_scene("t.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng a b \\\n  c\nf 1 2 \\\n 3 4\n");
  EXPECT_EQ(scene.triangles->indices, (ZeroedVector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(Obj, joinsLinesThatEndWithABackslash) {
  const std::string joined = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
  const std::string split =
      "v 0 \\\n0 0\nv\\\r\n 1 0\\ \t\r\n 0\n\\\nv 1 1 0 1 \\\n .5 .5\n# no statement: \\\nv 0 1 0 # \\\n"
      "vt 0 \\\n 0\nusemtl \\\n\\\nf\nf 1 \\\n\\\n2/1\\\n3\nf 1 3 \\\n 4 # \\\nf 1 2 3\nf 1 2 3 \\";
  const Scene a = mesh_scene("t.obj", joined + "f 1 2 3\nf 1 2 3\n"), b = mesh_scene("t.obj", split);
  EXPECT_EQ(a.triangles->vertices, b.triangles->vertices);
  EXPECT_EQ(a.triangles->indices, b.triangles->indices);
  EXPECT_EQ(mesh_error("t.obj", "v 0 \\\n 0 x\n"), "t.obj:2:4: error: `x` is not a number\n   0 x\n     ^\n");
  EXPECT_EQ(mesh_error("t.obj", "v 0 \\\n 0\n"), "t.obj:1:1: error: `v` needs three numbers: x y z\n  v 0 \\\n  ^\n");
  EXPECT_EQ(mesh_error("t.obj", "v 0 \\ 0 0\n"), "t.obj:1:5: error: `\\` is not a number\n  v 0 \\ 0 0\n      ^\n");
}

TEST(Obj, countsItsVerticesFromItsOwnFirst) {
  const Scene scene =
      scene_of(light + triangle + "mesh t.obj\nmesh t.obj\n", {}, {{"t.obj", "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\n"}});
  ASSERT_EQ(scene.root.objects.size(), 3u);
  EXPECT_EQ(corners(scene, 2)[1], (Vec3{6, 0, 0}));
}

TEST(Obj, saysWhatIsWrong) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(mesh_error("t.obj", "v 0 0\n"), "t.obj:1:1: error: `v` needs three numbers: x y z\n  v 0 0\n  ^\n");
  EXPECT_EQ(mesh_error("t.obj", "v 0 0 x\n"), "t.obj:1:7: error: `x` is not a number\n  v 0 0 x\n        ^\n");
  EXPECT_EQ(mesh_error("t.obj", "v 0 nan 0\n"), "t.obj:1:5: error: `nan` is not a number\n  v 0 nan 0\n      ^~~\n");
  EXPECT_EQ(mesh_error("t.obj", "v 0 1e39 0\n"),
            "t.obj:1:5: error: the number `1e39` is too large\n  v 0 1e39 0\n      ^~~~\n");
  EXPECT_EQ(mesh_error("t.obj", three + "f 1 2\n"),
            "t.obj:4:1: error: a face needs at least three corners; found 2\n  f 1 2\n  ^\n");
  EXPECT_EQ(mesh_error("t.obj", three + "f 1 2 4\n"),
            "t.obj:4:7: error: there is no vertex 4; 3 have been given so far\n  f 1 2 4\n        ^\n");
  EXPECT_EQ(mesh_error("t.obj", three + "f 1 2 0\n"),
            "t.obj:4:7: error: there is no vertex 0; 3 have been given so far\n  f 1 2 0\n        ^\n");
  EXPECT_EQ(mesh_error("t.obj", three + "f 1 2 -4\n"),
            "t.obj:4:7: error: there is no vertex -4; 3 have been given so far\n  f 1 2 -4\n        ^~\n");
  EXPECT_EQ(mesh_error("t.obj", three + "f 1 2 99999999999999999999\n"),
            "t.obj:4:7: error: `99999999999999999999` is not the number of a vertex\n"
            "  f 1 2 99999999999999999999\n        ^~~~~~~~~~~~~~~~~~~~\n");
  EXPECT_EQ(mesh_error("t.obj", three + "f 1 b 3\n"),
            "t.obj:4:5: error: `b` is not the number of a vertex\n  f 1 b 3\n      ^\n");
  EXPECT_EQ(mesh_error("t.obj", three + "face 1 2 3\n"),
            "t.obj:4:1: error: `face` is not a statement of an OBJ file\n  face 1 2 3\n  ^~~~\n");
  EXPECT_EQ(mesh_error("t.obj", three), "t.obj: error: this mesh has no faces\n");
  EXPECT_EQ(mesh_error("t.obj", ""), "t.obj: error: this mesh has no faces\n");
  EXPECT_EQ(told("scale 1e30 1 1\nscale 1e30 1 1\nmesh t.obj\n", {}, {{"t.obj", tetrahedron_obj}}),
            "s.cli:3:1: error: the current matrix has become too large\n  mesh t.obj\n  ^~~~\n");
  EXPECT_EQ(told("scale 1e30 1 1\nmesh t.obj\n", {}, {{"t.obj", "v 1e30 0 0\n"}}),
            "t.obj:1:1: error: the current matrix moves this vertex too far away\n  v 1e30 0 0\n  ^\n");
}

TEST(Mesh, hasToBeOfAKnownFormat) {
  EXPECT_EQ(mesh_error("t.stl", "solid\n"),
            "t.stl: error: a mesh has to be an OBJ file (NAME.obj) or a PLY file (its first line is `ply`)\n");
}

TEST(Ply, isReadAsText) {
  expect_square(mesh_scene("s.ply", ply_head("ascii", 4, 2) + "0 0 -4\n1 0 -4\n1 1 -4\n0 1 -4\n3 0 1 2\n3 0 2 3\n"));
  expect_square(mesh_scene("s.ply", ply_head("ascii", 4, 1) + "0 0 -4 1 0 -4\n1 1 -4\n0 1 -4\n\n4 0 1 2 3"));
  expect_square(mesh_scene("s.ply",
                           "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\nproperty float y\r\n"
                           "property float z\r\nelement face 1\r\nproperty list uchar int vertex_index\r\n"
                           "end_header\r\n0 0 -4\r\n1 0 -4\r\n1 1 -4\r\n0 1 -4\r\n4 0 1 2 3\r\n"));
}

TEST(Ply, isReadInEveryBinaryLayout) {
  for (const bool big : {false, true}) {
    for (const bool quad : {false, true}) {
      expect_square(
          mesh_scene("s.ply", binary_square<float, std::uint8_t, std::int32_t>(big, "float", "uchar int", quad)));
      expect_square(
          mesh_scene("s.ply", binary_square<float, std::uint8_t, std::uint32_t>(big, "float32", "uint8 uint32", quad)));
      expect_square(
          mesh_scene("s.ply", binary_square<double, std::uint8_t, std::int32_t>(big, "double", "uchar int", quad)));
      expect_square(
          mesh_scene("s.ply", binary_square<float, std::int32_t, std::int16_t>(big, "float", "int short", quad)));
      expect_square(
          mesh_scene("s.ply", binary_square<std::int8_t, std::int8_t, std::uint8_t>(big, "char", "char uchar", quad)));
      expect_square(mesh_scene(
          "s.ply", binary_square<std::int16_t, std::uint16_t, std::uint16_t>(big, "short", "ushort ushort", quad)));
      expect_square(
          mesh_scene("s.ply", binary_square<std::int32_t, std::uint32_t, std::int8_t>(big, "int", "uint char", quad)));
    }
  }
}

TEST(Ply, skipsWhatItDoesNotUse) {
  const std::string head =
      "ply\nformat {} 1.0\nobj_info x\nelement camera 1\nproperty float f\nproperty list uchar short extra\n"
      "element vertex 3\nproperty uchar red\nproperty float z\nproperty float x\nproperty double quality\nproperty "
      "float y\n"
      "element face 1\nproperty uchar flag\nproperty list uchar int vertex_indices\nproperty list uchar float "
      "texcoord\n"
      "element edge 1\nproperty int a\nend_header\n";
  const Scene text = mesh_scene("s.ply", fmt::format(fmt::runtime(head), "ascii") +
                                             "1.5 2 7 8\n255 3 1 nan 2\n0 6 4 0 5\n0 9 7 0 8\n1 3 0 1 2 2 .5 .5\n12\n");
  std::string data = fmt::format(fmt::runtime(head), "binary_little_endian");
  data += bytes_of(1.5f, false) + '\2' + bytes_of(std::int16_t{7}, false) + bytes_of(std::int16_t{8}, false);
  for (const float x : {1.f, 4.f, 7.f}) {
    data += '\0';
    data += bytes_of(x + 2, false) + bytes_of(x, false) + bytes_of(0.0, false) + bytes_of(x + 1, false);
  }
  data += "\1\3" + bytes_of(0, false) + bytes_of(1, false) + bytes_of(2, false);
  data += "\2" + bytes_of(.5f, false) + bytes_of(.5f, false) + bytes_of(12, false);
  const Scene binary = mesh_scene("s.ply", data);
  for (const Scene* scene : {&text, &binary}) {
    EXPECT_EQ(scene->triangles->vertices, (ZeroedVector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(scene->triangles->indices, (ZeroedVector<std::uint32_t>{0, 1, 2}));
  }
}

TEST(Ply, readsFacesInBulkUntilOneIsNoTriangle) {
  std::string data = ply_head("binary_little_endian", 4, 3);
  for (int i = 0; i < 12; i++) data += bytes_of(static_cast<float>(i), false);
  const auto face = [&](std::initializer_list<int> corner) {
    data += static_cast<char>(corner.size());
    for (const int i : corner) data += bytes_of(i, false);
  };
  face({0, 1, 2});
  face({0, 1, 2, 3});
  face({3, 2, 1});
  EXPECT_EQ(mesh_scene("s.ply", data).triangles->indices,
            (ZeroedVector<std::uint32_t>{0, 1, 2, 0, 1, 2, 0, 2, 3, 3, 2, 1}));
}

TEST(Ply, followsTheMatrix) {
  const Scene scene =
      mesh_scene("s.ply", binary_square<float, std::uint8_t, std::int32_t>(false, "float", "uchar int", false),
                 triangle + "translate 0 0 4\nscale 3 3 3\n");
  EXPECT_EQ(corners(scene, 1)[1], (Vec3{3, 0, -8}));
}

// The z component of (B-A)x(C-A) of a triangle of the store.
double outward_z(const Scene& scene, std::size_t triangle) {
  const auto corner = [&](std::size_t k) {
    const float* p = &scene.triangles->vertices[3 * std::size_t{scene.triangles->indices[3 * triangle + k]}];
    return Vec3{p[0], p[1], p[2]};
  };
  return cross(corner(1) - corner(0), corner(2) - corner(0)).z;
}

TEST(Mesh, keepsItsOutwardSideUnderAMatrixThatMirrors) {
  const Files files = {{"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}};
  EXPECT_GT(outward_z(scene_of("mesh m.obj\nrender\n", {}, files), 0), 0);
  EXPECT_GT(outward_z(scene_of("scale -1 1 1\nmesh m.obj\nrender\n", {}, files), 0), 0);
  EXPECT_LT(outward_z(scene_of("scale 1 1 -1\nmesh m.obj\nrender\n", {}, files), 0), 0);
}

TEST(Polygon, keepsItsOutwardSideUnderAMatrixThatMirrors) {
  const std::string square = "begin\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nend\nrender\n";
  for (std::size_t triangle = 0; triangle < 2; triangle++) {
    EXPECT_GT(outward_z(scene_of(square), triangle), 0);
    EXPECT_GT(outward_z(scene_of("scale 1 -1 1\n" + square), triangle), 0);
    EXPECT_LT(outward_z(scene_of("scale -1 -1 -1\n" + square), triangle), 0);
  }
}

TEST(Ply, saysWhatIsWrongWithTheHeader) {
  EXPECT_EQ(mesh_error("s.ply", "ply\n"),
            "s.ply: error: the header of this PLY file does not end: there is no `end_header`\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nformat utf8 1.0\n"),
            "s.ply:2:1: error: the format of a PLY file is `ascii`, `binary_little_endian` or `binary_big_endian`\n"
            "  format utf8 1.0\n  ^~~~~~\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nelement vertex 0\nend_header\n"),
            "s.ply:3:1: error: the header of this PLY file has no `format` line\n  end_header\n  ^~~~~~~~~~\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nfoo\n"), "s.ply:2:1: error: `foo` is not a line of a PLY header\n  foo\n  ^~~\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nelement vertex -4\n"),
            "s.ply:2:1: error: `element` needs a name and a number of elements\n  element vertex -4\n  ^~~~~~~\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nelement a 1\nelement a 1\n"),
            "s.ply:3:9: error: the element `a` is declared twice\n  element a 1\n          ^\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nproperty float x\n"),
            "s.ply:2:1: error: `property` before the first `element`\n  property float x\n  ^~~~~~~~\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nelement a 1\nproperty half x\n"),
            "s.ply:3:10: error: `half` is not a type of a PLY file\n  property half x\n           ^~~~\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nelement a 1\nproperty float\n"),
            "s.ply:3:1: error: `property` needs a type and a name, or `list`, two types and a name\n"
            "  property float\n  ^~~~~~~~\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nelement a 1\nproperty list float int x\n"),
            "s.ply:3:15: error: the length of a list has to be of an integer type\n"
            "  property list float int x\n                ^~~~~\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nformat ascii 1.0\nend_header\n"),
            "s.ply: error: this PLY file has no vertices\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n"),
            "s.ply: error: this mesh has no faces\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nformat ascii 1.0\nelement vertex 0\nelement tristrips 1\nend_header\n"),
            "s.ply: error: triangle strips are not supported; save the mesh with faces\n");
  EXPECT_EQ(
      mesh_error("s.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement face 0\nend_header\n1\n"),
      "s.ply:7:1: error: the vertices of this PLY file have no x, y and z\n  1\n  ^\n");
  EXPECT_EQ(mesh_error("s.ply",
                       "ply\nformat ascii 1.0\nelement vertex 4\nelement face 1\n"
                       "property list uchar int vertex_indices\nend_header\n5 0 0 1 2 3\n"),
            "s.ply:7:1: error: the vertices of this PLY file have no x, y and z\n  5 0 0 1 2 3\n  ^\n");
  EXPECT_EQ(mesh_error("s.ply", "ply\nformat ascii 1.0\nelement vertex 0\nelement face 1\nend_header\n1\n"),
            "s.ply:6:1: error: the vertices of this PLY file have no x, y and z\n  1\n  ^\n");
  EXPECT_EQ(mesh_error("s.ply",
                       "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                       "element face 1\nproperty int a\nend_header\n1\n"),
            "s.ply:10:1: error: the faces of this PLY file have no list `vertex_indices`\n  1\n  ^\n");
}

TEST(Ply, saysWhatIsWrongWithText) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  const auto wrong = [&](const std::string& rest) { return mesh_error("s.ply", ply_head("ascii", 3, 1) + rest); };
  EXPECT_EQ(wrong("0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"),
            "s.ply:12:3: error: element 2 of `vertex` should have a number here\n  1 x 0\n    ^\n");
  EXPECT_EQ(wrong("0 0 0\n1 0 1e39\n0 1 0\n3 0 1 2\n"),
            "s.ply:12:5: error: element 2 of `vertex` should have a number here\n  1 0 1e39\n      ^~~~\n");
  EXPECT_EQ(wrong(vertices + "3 0 1 3\n"),
            "s.ply:14:7: error: face 0 names vertex 3; there are 3, counted from 0\n  3 0 1 3\n        ^\n");
  EXPECT_EQ(wrong(vertices + "3 0 1 -1\n"),
            "s.ply:14:7: error: face 0 names vertex -1; there are 3, counted from 0\n  3 0 1 -1\n        ^~\n");
  EXPECT_EQ(wrong(vertices + "3 0 1 1.5\n"),
            "s.ply:14:7: error: face 0 names vertex 1.5; there are 3, counted from 0\n  3 0 1 1.5\n        ^~~\n");
  EXPECT_EQ(wrong(vertices + "2 0 1\n"),
            "s.ply:14:1: error: face 0 has 2 corners; it needs at least three\n  2 0 1\n  ^\n");
  EXPECT_EQ(wrong(vertices + "3.5 0 1 2\n"), "s.ply:14:1: error: a list cannot have length 3.5\n  3.5 0 1 2\n  ^~~\n");
  EXPECT_EQ(wrong(vertices + "-3 0 1 2\n"), "s.ply:14:1: error: a list cannot have length -3\n  -3 0 1 2\n  ^~\n");
  EXPECT_EQ(wrong(vertices + "2e30 0 1\n"),
            "s.ply:14:1: error: a list of 2e+30 numbers does not fit into the remaining 6 bytes\n  2e30 0 1\n  ^~~~\n");
  EXPECT_EQ(mesh_error("s.ply",
                       "ply\nformat ascii 1.0\nelement tag 1\nproperty list uchar int ids\n"
                       "element vertex 0\nelement face 0\nend_header\n2e30 1\n"),
            "s.ply:8:1: error: a list of 2e+30 numbers does not fit into the remaining 4 bytes\n  2e30 1\n  ^~~~\n");
  EXPECT_EQ(wrong(vertices + "3 0 1\n"),
            "s.ply:14:6: error: the file ends in element 1 of 1 of `face`\n  3 0 1\n       ^\n");
  EXPECT_EQ(mesh_error("s.ply", ply_head("ascii", 3, 0) + vertices), "s.ply: error: this mesh has no faces\n");
}

TEST(Ply, saysWhatIsWrongWithBytes) {
  const std::string square = binary_square<float, std::uint8_t, std::int32_t>(false, "float", "uchar int", false);
  const std::size_t data = ply_head("binary_little_endian", 4, 2).size();
  const auto changed = [&](std::size_t at, const std::string& bytes) {
    std::string copy = square;
    copy.replace(data + at, bytes.size(), bytes);
    return mesh_error("s.ply", copy);
  };
  const auto at = [&](std::size_t offset) { return fmt::format("(at byte {} of the file)\n", data + offset); };
  EXPECT_EQ(changed(12, bytes_of(std::numeric_limits<float>::infinity(), false)),
            "s.ply: error: vertex 1 is not finite " + at(12));
  EXPECT_EQ(changed(12, bytes_of(std::numeric_limits<float>::quiet_NaN(), false)),
            "s.ply: error: vertex 1 is not finite " + at(12));
  EXPECT_EQ(changed(62, bytes_of(4, false)),
            "s.ply: error: face 1 names vertex 4; there are 4, counted from 0 " + at(62));
  EXPECT_EQ(changed(62, bytes_of(-1, false)),
            "s.ply: error: face 1 names vertex -1; there are 4, counted from 0 " + at(62));
  EXPECT_EQ(changed(61, "\2"), "s.ply: error: face 1 has 2 corners; it needs at least three " + at(61));
  EXPECT_EQ(changed(61, "\4"), "s.ply: error: the file ends in element 2 of 2 of `face` " + at(74));
  EXPECT_EQ(mesh_error("s.ply", square.substr(0, data + 47)),
            "s.ply: error: 4 elements `vertex` do not fit into the remaining 47 bytes " + at(0));
}

TEST(Ply, doesNotBelieveInHugeNumbers) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    const std::string head = ply_head(format, 0, 0);
    for (const char* element : {"vertex", "face"}) {
      for (const char* count : {"4294967295", "1000000000000", "18446744073709551615"}) {
        std::string text = head;
        const std::string zero = fmt::format("element {} 0", element);
        text.replace(text.find(zero), zero.size(), fmt::format("element {} {}", element, count));
        EXPECT_NE(mesh_error("s.ply", text + "0 0 0 0").find("error"), std::string::npos);
      }
    }
  }
  std::string list = ply_head("binary_little_endian", 1, 1, "float", "uint int") + std::string(12, '\0');
  EXPECT_NE(mesh_error("s.ply", list + bytes_of(0xFFFFFFFFu, false)).find("does not fit into the remaining 0 bytes"),
            std::string::npos);
  EXPECT_NE(mesh_error("s.ply",
                       "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                       "property float z\nelement nothing 18446744073709551615\nelement face 1\n"
                       "property list uchar int vertex_indices\nend_header\n")
                .find("error"),
            std::string::npos);
}

}  // namespace
}  // namespace penumbra
