// A large file of a scene that becomes shorter while it is read ends in a message.
#include <fmt/format.h>

#include <filesystem>

#include "base/test_folder.hpp"
#include "support.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t large = std::size_t{20} << 20;  // so large that it is mapped

// Text of that size, in lines.
std::string repeated(const std::string& line) {
  std::string text;
  text.reserve(large + line.size());
  while (text.size() < large) text += line;
  return text;
}

// What is said if `file` is cut to half as soon as it is open.
std::string told_when_cut(const fs::path& scene, const fs::path& file) {
  const FileLoader load = [&](const fs::path& path) {
    LoadedFile loaded = load_from_disk(path);
    if (path == file) fs::resize_file(file, large / 2);
    return loaded;
  };
  return told(read_scene_with(scene, std::nullopt, {}, load));
}

class ShrinkingFile : public testing::Test {
 protected:
  test::TestFolder folder_;
  const fs::path scene_ = folder_ / "s.cli";
};

TEST_F(ShrinkingFile, Scene) {
  test::put_content(scene_, light + ball + repeated("# nothing but a comment, again and again\n"));
  EXPECT_EQ(told_when_cut(scene_, scene_),
            fmt::format("{}: error: the file became shorter while it was read\n", scene_.string()));
}

TEST_F(ShrinkingFile, FileThatASceneReads) {
  test::put_content(folder_ / "part.cli", repeated("# nothing but a comment, again and again\n"));
  test::put_content(scene_, light + ball + "read part.cli\n");
  EXPECT_EQ(told_when_cut(scene_, folder_ / "part.cli"),
            fmt::format("{}:3:6: error: the file became shorter while it was read\n  read part.cli\n       ^~~~~~~~\n",
                        scene_.string()));
}

TEST_F(ShrinkingFile, Mesh) {
  const std::string error = scene_.string() + ":2:6: error: the file became shorter while it was read\n";
  const std::string vertices = repeated("v 1 2 3\n");
  const std::string binary = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n",
      large / 12);
  for (const std::string& mesh : {vertices + "f 1 2 3\n", binary + std::string(large / 12 * 12, 'a') +
                                                              std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13)}) {
    const fs::path file = folder_ / "part.obj";
    test::put_content(file, mesh);
    test::put_content(scene_, light + "mesh part.obj\n");
    EXPECT_FALSE(has_error(read_scene(scene_, {}).diagnostics));
    EXPECT_TRUE(told_when_cut(scene_, file).starts_with(error)) << told_when_cut(scene_, file);
  }
}

}  // namespace
}  // namespace penumbra
