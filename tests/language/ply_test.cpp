// PLY files, valid and invalid.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>

#include "mesh_support.hpp"

namespace penumbra {
namespace {

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

std::string strip_head(const std::string& format, const std::string& strips, const std::string& list) {
  std::string head = ply_head(format, 5, 0, "float", list);
  const std::string face = "element face 0";
  return head.replace(head.find(face), face.size(), "element tristrips " + strips);
}

TEST(Ply, readsTriangleStrips) {
  const ZeroedVector<std::uint32_t> wanted{0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 0, 3, 4, 0, 1, 2, 3, 0, 1, 4};
  const std::string vertices = "0 0 0 1 0 0 1 1 0 0 1 0 2 2 2 ";
  // Short strips, and corners twice to lead on.
  const std::vector<std::vector<int>> lists = {
      {0, 1, 2, 3, 4, 0, -1, -1, 0, 1, -1, 3, 4, 0, -1, 1, 2, 3}, {-1, 1, 1, 0, 4, -1, 0}, {}};
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const bool big = format == std::string("binary_big_endian");
    std::string file = strip_head(format, "3", "int int");
    if (format == std::string("ascii")) {
      file += vertices;
      for (const auto& list : lists) file += fmt::format("{} {}\n", list.size(), fmt::join(list, " "));
    } else {
      for (const float v : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 2, 2}) file += bytes_of(v, big);
      for (const auto& list : lists) {
        file += bytes_of(static_cast<int>(list.size()), big);
        for (const int i : list) file += bytes_of(i, big);
      }
    }
    EXPECT_EQ(mesh_scene("s.ply", file).triangles->indices, wanted) << format;
  }
}

TEST(Ply, saysWhatIsWrongWithStrips) {
  const std::string vertices = "0 0 0 1 0 0 1 1 0 0 1 0 2 2 2\n";
  const std::string head = strip_head("ascii", "1", "int int");
  EXPECT_EQ(mesh_error("s.ply", head + vertices + "4 0 1 2 -2\n"),
            "s.ply:12:9: error: strip 0 names vertex -2; there are 5, counted from 0\n  4 0 1 2 -2\n          ^~\n");
  EXPECT_EQ(mesh_error("s.ply", head + vertices + "4 0 1 2 5\n"),
            "s.ply:12:9: error: strip 0 names vertex 5; there are 5, counted from 0\n  4 0 1 2 5\n          ^\n");
  EXPECT_EQ(mesh_error("s.ply", head + vertices + "4 0 1 -1 2\n"), "s.ply: error: this mesh has no faces\n");
}

TEST(Ply, followsTheMatrix) {
  const Scene scene =
      mesh_scene("s.ply", binary_square<float, std::uint8_t, std::int32_t>(false, "float", "uchar int", false),
                 triangle + "translate 0 0 4\nscale 3 3 3\n");
  EXPECT_EQ(corners(scene, 1)[1], (Vec3{3, 0, -8}));
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
