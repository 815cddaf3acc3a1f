// Files that read files, from memory and from the disk.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/test_folder.hpp"
#include "support.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

TEST(Read, goesOnWithTheCurrentMatrixAndSurface) {
  const Scene scene = scene_of(light + "translate 1 0 0\nsurface 1 0 0\nread b.cli\nsphere 1 0 0 0\n", {},
                               {{"b.cli", "sphere 2 0 0 0\ntranslate 0 1 0\nsurface 0 1 0\n"}});
  ASSERT_EQ(scene.root.objects.size(), 2u);
  EXPECT_EQ(scene.placements[scene.root.objects[0].placement].translation, (Vec3{1, 0, 0}));
  EXPECT_EQ(scene.surfaces[scene.root.objects[0].surface].diffuse, (Vec3{1, 0, 0}));
  EXPECT_EQ(scene.placements[scene.root.objects[1].placement].translation, (Vec3{1, 1, 0}));
  EXPECT_EQ(scene.surfaces[scene.root.objects[1].surface].diffuse, (Vec3{0, 1, 0}));
}

TEST(Read, findsFilesBesideTheOneThatSaysIt) {
  const SceneFile file = read(light + "read d/b.cli\nmesh d/m.obj\n", {},
                              {{"d/b.cli", "read c.cli\nmesh m.obj\n"},
                               {"d/c.cli", ball},
                               {"d/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}});
  EXPECT_EQ(told(file), "");
  EXPECT_EQ(file.files, (std::vector<std::string>{"s.cli", "d/b.cli", "d/c.cli", "d/m.obj"}));
}

TEST(Read, takesAPartOfAPolygonOrGroup) {
  EXPECT_EQ(told(light + "begin_list\nbegin\nread b.cli\nend\nread c.cli\n", {},
                 {{"b.cli", "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"}, {"c.cli", "end_list"}}),
            "");
}

TEST(Read, takesPicturesInsideOtherFiles) {
  const SceneFile file = read(light + ball + "read b.cli\nread b.cli\n", {}, {{"b.cli", "render\n" + ball}});
  EXPECT_EQ(pictures(file).size(), 2u);
}

TEST(Read, refusesTwoPicturesOfOneName) {
  const std::string scene = light + ball + "write a.png\nread b.cli\n";
  const std::string said = told(read(scene, {}, {{"b.cli", "write b.png\nwrite ./a.png\n"}}));
  EXPECT_EQ(said,
            "b.cli:2:7: error: `./a.png` is written at s.cli:3 already, and this picture would replace it\n"
            "  write ./a.png\n        ^~~~~~~\n");
}

TEST(Read, saysWhatCannotBeRead) {
  EXPECT_EQ(told("read  nothing.cli\n"),
            "s.cli:1:7: error: cannot read `nothing.cli`: no such file\n  read  nothing.cli\n        ^~~~~~~~~~~\n");
  EXPECT_EQ(told("mesh nothing.obj\n"),
            "s.cli:1:6: error: cannot read `nothing.obj`: no such file\n  mesh nothing.obj\n       ^~~~~~~~~~~\n");
}

TEST(Read, offersAFileWhoseNameIsNear) {
  const test::TestFolder folder;
  test::put_content(folder / "cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  test::put_content(folder / "s.cli",
                    "mesh cub.obj\nmesh ../" + folder.path().filename().string() + "/cube.objj\nmesh b.obj\n");
  const std::string scene = folder / "s.cli";
  const std::string text = told(read_scene(scene, {}));
  EXPECT_NE(text.find("  mesh cub.obj\n       ^~~~~~~\n  did you mean `cube.obj`?\n"), text.npos) << text;
  EXPECT_NE(text.find("/cube.obj`?\n"), text.npos) << text;
  EXPECT_NE(text.find("  mesh b.obj\n       ^~~~~\n"), text.npos) << text;
  EXPECT_EQ(text.substr(text.size() - 6), "^~~~~\n") << "none is near";
  EXPECT_NE(told(read_scene(folder / "ss.cli", {})).find("did you mean `" + scene + "`?\n"), text.npos);
}

TEST(Name, mayBeQuoted) {
  const Files files = {{"my mesh #1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}, {"a \\b.cli", ball}};
  const SceneFile file =
      read(light +
               "mesh \"my mesh #1.obj\" # a comment\nread \"a \\b.cli\"\nnamed_object \"the ball\"#\n"
               "instance \"the ball\"\nsphere 1 0 0 -4\nnamed_object ball\ninstance \"ball\"\n"
               "write \"my picture.png\"\n",
           {}, files);
  EXPECT_EQ(told(file), "");
  EXPECT_EQ(pictures(file).front().file, "my picture.png");
  EXPECT_EQ(pictures(file).front().scene->root.objects.size(), 3u);
}

TEST(Name, saysWhatIsWrongWithQuotes) {
  EXPECT_EQ(told("mesh \"my mesh.obj  # x\n"),
            "s.cli:1:6: error: this `\"` has no `\"` on the same line\n  mesh \"my mesh.obj  # x\n       ^\n");
  EXPECT_EQ(told("mesh \"\n"), "s.cli:1:6: error: this `\"` has no `\"` on the same line\n  mesh \"\n       ^\n");
  EXPECT_EQ(told("write \"\"\n"),
            "s.cli:1:7: error: there is nothing between these quotes\n  write \"\"\n        ^~\n");
  EXPECT_EQ(told("read \"a b\".cli\n"),
            "s.cli:1:11: error: `.cli` may not follow a `\"` without a blank\n  read \"a b\".cli\n            ^~~~\n");
  EXPECT_EQ(told("mesh my cube.obj\n"),
            "s.cli:1:9: error: only `flat` may follow the file name; found `cube.obj`\n  mesh my cube.obj\n          "
            "^~~~~~~~\n"
            "  a name with blanks has to stand in double quotes\n");
  EXPECT_EQ(told("read \"no thing\"\n"),
            "s.cli:1:6: error: cannot read `no thing`: no such file\n  read \"no thing\"\n       ^~~~~~~~~~\n");
  EXPECT_EQ(
      told("sphere \"1\" 0 0 0\n"),
      "s.cli:1:8: error: `radius` of `sphere` has to be a number; found `\"1\"`\n  sphere \"1\" 0 0 0\n         ^~~\n");
}

TEST(Read, refusesAFileThatReadsItself) {
  EXPECT_EQ(told("read s.cli\n"), "s.cli:1:6: error: this file reads itself\n  read s.cli\n       ^~~~~\n");
  EXPECT_EQ(told("read b.cli\n", {}, {{"b.cli", "\nread s.cli\n"}}),
            "b.cli:2:6: error: this file reads itself again, by way of `b.cli`\n  read s.cli\n       ^~~~~\n");
  EXPECT_EQ(told("read b.cli\n", {}, {{"b.cli", "read d/../b.cli\n"}, {"d/../b.cli", ""}}),
            "b.cli:1:6: error: this file reads itself\n  read d/../b.cli\n       ^~~~~~~~~~\n");
}

TEST(Read, mayReadOneFileAgainAndAgain) {
  const Scene scene = scene_of(light + "read b.cli\nread b.cli\nread b.cli\n", {}, {{"b.cli", ball}});
  EXPECT_EQ(scene.root.objects.size(), 3u);
}

TEST(Read, tellsAMissingSceneFromAWrongOne) {
  const SceneFile file = read_scene_with("none.cli", std::nullopt, {}, in_memory({}));
  EXPECT_FALSE(file.found);
  EXPECT_EQ(told(file), "none.cli: error: cannot read this file: no such file\n");
  EXPECT_TRUE(read("foo").found);
  EXPECT_TRUE(read("read none.cli").found);
}

// A folder of files that is removed at the end of a test.
class OnDisk : public ::testing::Test {
 protected:
  OnDisk() : folder(fs::temp_directory_path() / ("penumbra-language-test-" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~OnDisk() override { fs::remove_all(folder); }
  fs::path put(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  const fs::path folder;
};

TEST_F(OnDisk, readsASceneAndWhatItNames) {
  put("b.cli", ball);
  const SceneFile file = read_scene(put("a.cli", light + "read b.cli\nwrite x.png\n"), {});
  EXPECT_EQ(told(file), "");
  EXPECT_EQ(pictures(file).at(0).scene->root.objects.size(), 1u);
  EXPECT_FALSE(fs::exists("x.png"));
}

TEST_F(OnDisk, readsTextAsIfItWereTheFile) {
  put("b.cli", ball);
  const fs::path path = put("a.cli", "nonsense\n");
  EXPECT_EQ(told(read_scene_text(light + "read b.cli\n", path, {})), "");
  EXPECT_EQ(told(read_scene_text(light + "read b.cli\n", folder / "not-yet-saved.cli", {})), "");
  EXPECT_EQ(told(read_scene_text("read a.cli\n", path, {})),
            path.string() + ":1:6: error: this file reads itself\n  read a.cli\n       ^~~~~\n");
}

TEST_F(OnDisk, seesThroughLinksWhenAFileReadsItself) {
  const fs::path path = put("a.cli", "read link.cli\n");
  fs::create_symlink("a.cli", folder / "link.cli");
  EXPECT_EQ(told(read_scene(path, {})),
            path.string() + ":1:6: error: this file reads itself\n  read link.cli\n       ^~~~~~~~\n");
}

TEST_F(OnDisk, saysWhyAFileCannotBeRead) {
  EXPECT_EQ(told(read_scene(folder / "none.cli", {})),
            (folder / "none.cli").string() + ": error: cannot read this file: No such file or directory\n");
  EXPECT_EQ(told(read_scene(folder, {})), folder.string() + ": error: cannot read this file: it is a folder\n");
  EXPECT_EQ(told(read_scene("/dev/zero", {})), "/dev/zero: error: cannot read this file: it is not a regular file\n");
  fs::create_directory(folder / "d.cli");
  EXPECT_EQ(told(read_scene(put("a.cli", "read d.cli\n"), {})),
            (folder / "a.cli").string() + ":1:6: error: cannot read `" + (folder / "d.cli").string() +
                "`: it is a folder\n  read d.cli\n       ^~~~~\n");
  if (::geteuid() == 0) return;
  fs::permissions(put("locked.cli", ball), fs::perms::none);
  EXPECT_EQ(told(read_scene(folder / "locked.cli", {})),
            (folder / "locked.cli").string() + ": error: cannot read this file: Permission denied\n");
}

TEST_F(OnDisk, readsALargeFileInPlace) {
  std::string text = light;
  while (text.size() < (20u << 20)) text += triangle;
  const std::size_t expected = (text.size() - light.size()) / triangle.size();
  const SceneFile file = read_scene(put("large.cli", text), {});
  ASSERT_EQ(told(file), "");
  const Scene& scene = *pictures(file).at(0).scene;
  EXPECT_EQ(scene.triangles->triangle_count(), expected);
  EXPECT_EQ(scene.root.objects.size(), 1u);
  EXPECT_LE(scene.triangles->vertices.capacity() * sizeof(float), expected * 36 * 5 / 4) << "memory does not double";

  const SceneFile wrong = read_scene(put("large.cli", text + "spere 1 0 0 0"), {});
  ASSERT_EQ(wrong.diagnostics.size(), 1u);
  EXPECT_EQ(wrong.diagnostics[0].line, static_cast<int>(2 + 5 * expected));
  EXPECT_EQ(wrong.diagnostics[0].source_line, "spere 1 0 0 0");
}

TEST_F(OnDisk, readsALargeMeshInPlace) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  while (text.size() < (20u << 20)) text += "f 1 2 3\n";
  put("m.obj", text);
  const SceneFile file = read_scene(put("a.cli", light + "mesh m.obj\n"), {});
  ASSERT_EQ(told(file), "");
  EXPECT_EQ(pictures(file).at(0).scene->triangles->triangle_count(), (text.size() - 24) / 8);
}

}  // namespace
}  // namespace penumbra
