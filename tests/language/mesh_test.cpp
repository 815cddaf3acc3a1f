// OBJ files, valid and invalid, and what all meshes have in common.
#include "mesh_support.hpp"

namespace penumbra {
namespace {

const std::string tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

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

}  // namespace
}  // namespace penumbra
