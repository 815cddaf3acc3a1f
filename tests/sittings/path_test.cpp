// No file serves two purposes, nothing that a user has is lost, and what keeps a file from being written shows before
// anything is rendered.
#include <filesystem>
#include <span>

#include "app/files/rescue.hpp"
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

namespace fs = std::filesystem;

const std::string ball = "image_size 8 6\nlight 0 9 9 1 1 1\nsphere 1 0 0 -5\n";

class Path : public SittingTest {
 protected:
  Path() { put_content(scene_, ball); }

  // Expects 64, both names in the message, and no file that was not there before.
  void refuses(const std::string& command, const std::string& one, const std::string& other) const {
    SCOPED_TRACE(command);
    const Words before = folder_.names();
    const ProgramResult result = shell(command);
    EXPECT_EQ(result.exit_code, 64) << result.output;
    EXPECT_NE(result.output.find("`" + one + "` ("), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("`" + other + "` ("), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("are the same file"), std::string::npos) << result.output;
    EXPECT_EQ(folder_.names(), before);
  }
};

TEST_F(Path, ServesOnePurpose) {
  refuses("$P render scene.cli -o o.png --checkpoint ./o.png", "./o.png", "o.png");
  refuses("$P render scene.cli -o o.png --stats o.png", "o.png", "o.png");
  refuses("$P render scene.cli -o o.png --stats scene.cli", "scene.cli", "scene.cli");
  refuses("$P render scene.cli -o o.png -o ./o.png", "o.png", "./o.png");
  refuses("$P render scene.cli -o o.png --checkpoint c --stats c.previous", "c.previous", "c.previous");
  refuses("$P render scene.cli -o o.png --checkpoint c --stats c", "c", "c");
  refuses("$P render scene.cli -o o.png --frames 0-1 -o o.####.png", "o.0000.png", "o.0000.png");
  refuses("$P render scene.cli -o 1#.png -o '#.png' --frames 1-11", "11.png", "11.png");
  refuses("$P farm submit scene.cli -o o.png --folder ./o.png --dry-run", "./o.png", "o.png");
  EXPECT_EQ(content_of(scene_), ball);
}

TEST_F(Path, IsAFileWhateverItsName) {
  fs::create_symlink("o.png", path("to-nothing.png"));
  refuses("$P render scene.cli -o o.png -o to-nothing.png", "o.png", "to-nothing.png");
  fs::create_symlink("scene.cli", path("to-scene.json"));
  refuses("$P render scene.cli -o o.png --stats to-scene.json", "to-scene.json", "scene.cli");
  fs::create_directory_symlink(".", path("here"));
  refuses("$P render scene.cli -o o.png --stats here/o.png", "here/o.png", "o.png");
  fs::create_hard_link(scene_, path("second.json"));
  refuses("$P render scene.cli -o o.png --stats second.json", "second.json", "scene.cli");
  EXPECT_EQ(content_of(scene_), ball);
}

TEST_F(Path, OfWhatTheSceneReadsIsNoOutput) {
  put_content(path("part.png"), "sphere 1 0 0 -5\n");
  put_content(
      path("mesh.png"),
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 -5\n1 0 -5\n0 1 -5\n3 0 1 2\n");
  put_content(scene_, ball + "read part.png\nmesh mesh.png\n");
  refuses("$P render scene.cli -o part.png", "part.png", "part.png");
  refuses("$P render scene.cli -o mesh.png", "mesh.png", "mesh.png");
  put_content(scene_, ball + "read part.png\nwrite part.png\n");
  refuses("$P render scene.cli", "part.png", "part.png");
  refuses("$P check scene.cli", "part.png", "part.png");
  put_content(scene_, ball + "render\nwrite scene.png\n");
  refuses("$P render scene.cli", "scene.png", "scene.png");
}

TEST_F(Path, OfAPipeIsItsFile) {
  fs::copy_file(scene_, path("o.png"));
  refuses("$P render - -o o.png < o.png", "/dev/stdin", "o.png");
  EXPECT_EQ(content_of(path("o.png")), ball);
  refuses("$P render scene.cli -o o.png -o - > o.png", "o.png", "/dev/stdout");
  EXPECT_EQ(shell("$P render scene.cli --quiet -o a.png --stats /dev/null -o - > /dev/null").exit_code, 0);
  EXPECT_EQ(shell("$P render scene.cli --quiet -o a.png --stats /dev/stdout | grep -q rays").exit_code, 0);
}

TEST_F(Path, OfOtherCommandsServesOnePurposeToo) {
  ASSERT_EQ(shell("$P render scene.cli --quiet -o a.png && $P render scene.cli --quiet --shard 0/1 -o p.exr").exit_code,
            0);
  const std::string picture = content_of(path("a.png")), part = content_of(path("p.exr"));
  refuses("$P compare a.png a.png --heatmap ./a.png", "a.png", "./a.png");
  refuses("$P merge p.exr -o ./p.exr", "p.exr", "./p.exr");
  refuses("$P merge p.exr -o o.exr -o ./o.exr", "o.exr", "./o.exr");
  EXPECT_EQ(content_of(path("a.png")), picture);
  EXPECT_EQ(content_of(path("p.exr")), part);
}

TEST_F(Path, IsWrittenOnceByAScene) {
  put_content(scene_, ball + "write a.png\nsphere 1 1 0 -5\nwrite ./a.png\n");
  const ProgramResult result = shell("$P render scene.cli");
  EXPECT_EQ(result.exit_code, 65);
  EXPECT_NE(result.output.find("scene.cli:6:7: error: `./a.png` is written at scene.cli:4 already"), std::string::npos)
      << result.output;
  EXPECT_EQ(shell("$P check scene.cli").exit_code, 65);
  EXPECT_EQ(others(), Words{});
}

// No file of another kind is replaced or removed.
TEST_F(Path, OfACheckpointReplacesNothingElse) {
  put_content(path("c.previous"), "mine");
  put_content(path("empty"), "");
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", path("c")}), 73);
  EXPECT_NE(said().find("it would replace `" + path("c.previous") + "`, a file of another kind"), std::string::npos)
      << said();
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", path("c"), "--resume"}), 73);
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", path("empty")}), 73);
  fs::rename(path("c.previous"), path("c"));
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", path("c"), "--resume"}), 65);
  EXPECT_EQ(others(), (Words{"c", "empty"}));
  EXPECT_EQ(content_of(path("c")), "mine");
}

// A render of so many rays would not end.
TEST_F(Path, ThatCannotBeWrittenIsFoundBeforeTheFirstRay) {
  const Words endless = {"--rays", "16000000", "--size", "1000x1000"};
  fs::create_directory(path("folder.png"));
  fs::create_directory(path("c.previous"));
  const std::string long_name = std::string(253, 'a') + ".png";
  for (const Words& wrong :
       {Words{"-o", path("folder.png")}, Words{"-o", path(long_name)},
        Words{"-o", path("a.png"), "--stats", path("none/stats")}, Words{"-o", path("a.png"), "--stats", "/"},
        Words{"-o", path("a.png"), "--checkpoint", path("c")},
        Words{"-o", path("a.png"), "--checkpoint", path("none/c")},
        Words{"-o", path("a.png"), "--checkpoint", path(std::string(250, 'c'))}}) {
    EXPECT_EQ(render(endless + wrong), 73) << wrong.back() << said();
    EXPECT_TRUE(said().starts_with("penumbra: cannot ")) << said();
  }
  EXPECT_EQ(others(), (Words{"c.previous", "folder.png"}));
  EXPECT_EQ(shell("$P render scene.cli --rays 16000000 --size 1000x1000 -o - >&-").exit_code, 73);
}

TEST_F(Path, OfAnExrNeedsItsModuleAtOnce) {
  fs::copy_file(PENUMBRA_PROGRAM, path("alone"));
  const ProgramResult result = shell("./alone render scene.cli --rays 16000000 --size 999x999 -o a.exr");
  EXPECT_EQ(result.exit_code, 73) << result.output;
  EXPECT_NE(result.output.find("libpenumbra_exr.so"), std::string::npos) << result.output;
}

TEST_F(Path, OfARescuedFileIsInAFolderThatIsThere) {
  const fs::path old = fs::current_path();
  fs::current_path(folder_.path());
  const std::string text = "picture";
  const auto bytes = std::as_bytes(std::span(text));
  EXPECT_EQ(rescue(path("gone/a.png"), bytes), "a.rescued.png");
  EXPECT_EQ(rescue(path("gone/a.png"), bytes), "a.rescued-2.png");
  EXPECT_EQ(rescue(path(std::string(300, 'b') + ".exr"), bytes), path(std::string(100, 'b') + ".rescued.exr"));
  EXPECT_EQ(rescue("/dev/stdout", bytes), "picture.rescued.png");
  fs::current_path(old);
  EXPECT_EQ(content_of(path("a.rescued-2.png")), text);
  EXPECT_EQ(content_of(path("picture.rescued.png")), text);
}

}  // namespace
}  // namespace penumbra::test
