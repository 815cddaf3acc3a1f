// The vertex normals of mesh files: which corner has which, how they follow the matrix, and which faces stay flat.
#include <fmt/format.h>

#include <cstring>

#include "mesh_support.hpp"

namespace penumbra {
namespace {

const std::string triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
const std::string normals_obj = "vn 1 0 0\nvn 0 3 0\nvn 0 0 .5\n";

// The normals of the corners of a triangle of the last object; none if it is flat.
std::vector<Vec3> normals(const Scene& scene, std::size_t triangle) {
  const TriangleStore& store = *scene.triangles;
  const auto& range = shape_of<TriangleRange>(scene.root.objects.back());
  std::vector<Vec3> list;
  if (range.normals == TriangleRange::flat) return list;
  for (std::size_t k = 0; k < 3; k++) {
    const std::uint32_t number = store.normal_numbers.at(3 * (range.normals + triangle) + k);
    if (number == 0) continue;
    list.push_back(
        {store.normals.at(3 * number - 3), store.normals.at(3 * number - 2), store.normals.at(3 * number - 1)});
  }
  EXPECT_TRUE(list.empty() || list.size() == 3);
  return list;
}

const std::vector<Vec3> axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<Vec3> flat;

TEST(MeshNormals, areThoseOfTheCornersOfAnObjFile) {
  const Scene scene = mesh_scene("t.obj", triangle_obj + normals_obj +
                                              "f 1 2 3\nf 1//1 2//2 3//3\nf 1/7/1 2/8/2 3//-1\nf 1 2//2 3//3\n"
                                              "f 3//1 2//2 1//3\nf 1/1 2/1/ 3//\n");
  EXPECT_EQ(normals(scene, 0), flat);
  EXPECT_EQ(normals(scene, 1), axes);
  EXPECT_EQ(normals(scene, 2), axes);
  EXPECT_EQ(normals(scene, 3), flat) << "not all corners have one";
  EXPECT_EQ(normals(scene, 4), axes);
  EXPECT_EQ(normals(scene, 5), flat);
  const Scene two = scene_of(light + triangle + "mesh t.obj\nmesh t.obj\n", {},
                             {{"t.obj", triangle_obj + normals_obj + "f 1//1 2//2 3//3\nf 2 3 4\n"}});
  EXPECT_EQ(normals(two, 0), axes);
  EXPECT_EQ(normals(two, 1), flat);
}

TEST(MeshNormals, stayWithTheCornersOfAPolygon) {
  const std::string arrow = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\nvn -1 0 0\n";
  const Scene scene = mesh_scene("t.obj", arrow + "f 1//1 2//2 3//3 4//4\n");
  const std::vector<Vec3> of_vertex = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
  for (std::size_t t = 0; t < 2; t++) {
    const std::vector<Vec3> found = normals(scene, t);
    ASSERT_EQ(found.size(), 3u);
    for (std::size_t k = 0; k < 3; k++) EXPECT_EQ(found[k], of_vertex[scene.triangles->indices[3 * t + k]]);
  }
}

TEST(MeshNormals, leaveFacesFlatWhereTheyAreNoDirections) {
  for (const std::string bad : {"vn 0 0 0", "vn nan nan nan", "vn 1 inf 0", "vn 1e39 0 0", "vn 1 0", "vn x y z"}) {
    const Scene scene =
        mesh_scene("t.obj", triangle_obj + normals_obj + bad + "\nf 1//1 2//2 3//4\nf 1//1 2//2 3//3\n");
    EXPECT_EQ(normals(scene, 0), flat) << bad;
    EXPECT_EQ(normals(scene, 1), axes) << bad;
  }
}

TEST(MeshNormals, areLeftOutByTheWordFlat) {
  const Files files = {{"t.obj", triangle_obj + "vn 1 0 0\nf 1//1 2//1 3//9\n"}};
  EXPECT_EQ(
      told("mesh t.obj\n", {}, files),
      "t.obj:6:13: error: there is no normal 9; 1 have been given so far\n  f 1//1 2//1 3//9\n              ^~~~\n");
  const Scene scene = scene_of(light + "mesh t.obj flat\n", {}, files);
  EXPECT_EQ(normals(scene, 0), flat);
  EXPECT_TRUE(scene.triangles->normals.empty());
  EXPECT_EQ(told("mesh t.obj smooth\n", {}, files).substr(0, 74),
            "s.cli:1:12: error: only `flat` may follow the file name; found `smooth`\n  ");
  EXPECT_EQ(mesh_error("t.obj", triangle_obj + "vn 1 0 0\nf 1//1 2//x 3//1\n"),
            "t.obj:6:8: error: `2//x` is not the number of a normal\n  f 1//1 2//x 3//1\n         ^~~~\n");
}

TEST(MeshNormals, followTheInverseTransposeOfTheMatrix) {
  const Files files = {{"t.obj", triangle_obj + "vn 1 1 0\nvn 0 0 2\nvn 0 1 1\nf 1//1 2//2 3//3\n"}};
  const auto under = [&](const std::string& matrix) { return scene_of(light + matrix + "mesh t.obj\n", {}, files); };
  const double s = std::sqrt(0.5);
  std::vector<Vec3> found = normals(under("translate 5 6 7\n"), 0);
  expect_near(found[0], {s, s, 0}, 1e-6);
  expect_near(found[1], {0, 0, 1}, 1e-6);
  found = normals(under("scale 2 4 8\n"), 0);
  expect_near(found[0], normalize({1 / 2., 1 / 4., 0}), 1e-6);
  expect_near(found[2], normalize({0, 1 / 4., 1 / 8.}), 1e-6);
  found = normals(under("rotatez 90\n"), 0);
  expect_near(found[0], {-s, s, 0}, 1e-6);
  // The corners of a triangle under a matrix that mirrors change places.
  found = normals(under("scale -1 1 1\n"), 0);
  expect_near(found[0], {-s, s, 0}, 1e-6);
  expect_near(found[1], {0, s, s}, 1e-6);
  expect_near(found[2], {0, 0, 1}, 1e-6);
}

std::string ply(const std::string& format, const std::string& type, const std::string& first) {
  return fmt::format(
      "ply\nformat {0} 1.0\nelement vertex 4\nproperty {1} x\n{2}property {1} y\nproperty {1} z\n"
      "property {1} nx\nproperty {1} ny\nproperty {1} nz\nelement face 2\nproperty list uchar int vertex_indices\n"
      "end_header\n",
      format, type, first);
}

TEST(MeshNormals, areThoseOfTheVerticesOfAPlyFile) {
  const Scene text =
      mesh_scene("t.ply", ply("ascii", "float", "") +
                              "0 0 0 1 0 0\n1 0 0 0 5 0\n0 1 0 0 0 1\n1 1 0 nan -nan(ind) 0\n3 0 1 2\n3 2 1 3\n");
  EXPECT_EQ(normals(text, 0), axes);
  EXPECT_EQ(normals(text, 1), flat);
  const auto binary = [](auto number, const std::string& type, const std::string& first) {
    using Number = decltype(number);
    std::string data = ply("binary_little_endian", type, first);
    const auto add = [&](auto value) {
      char bytes[sizeof value];
      std::memcpy(bytes, &value, sizeof value);
      data.append(bytes, sizeof value);
    };
    const int vertex[4][6] = {{0, 0, 0, 1, 0, 0}, {1, 0, 0, 0, 5, 0}, {0, 1, 0, 0, 0, 1}, {1, 1, 0, 0, 0, 0}};
    for (const auto& v : vertex) {
      for (int k = 0; k < 6; k++) {
        add(static_cast<Number>(v[k]));
        if (k == 0 && !first.empty()) data += 'x';
      }
    }
    for (const int face : {0, 2}) {
      data += '\3';
      for (const int corner : {face, 1, face == 0 ? 2 : 3}) add(corner);
    }
    return data;
  };
  for (const std::string& first : {std::string(), std::string("property uchar red\n")}) {
    for (const std::string& data : {binary(1.0f, "float", first), binary(1.0, "double", first)}) {
      const Scene scene = mesh_scene("t.ply", data);
      EXPECT_EQ(scene.triangles->vertices, (ZeroedVector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}));
      EXPECT_EQ(normals(scene, 0), axes);
      EXPECT_EQ(normals(scene, 1), flat);
      EXPECT_TRUE(scene_of(light + "mesh t.ply flat\n", {}, {{"t.ply", data}}).triangles->normals.empty());
    }
  }
}

}  // namespace
}  // namespace penumbra
