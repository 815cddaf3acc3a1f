// Scenes from standard input and pictures on standard output.
#include <algorithm>
#include <filesystem>

#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

const std::string small = "image_size 8 6\nlight 0 9 9 1 1 1\nsphere 1 0 0 -5\n";

class Pipe : public SittingTest {
 protected:
  Pipe() { put_content(scene_, small); }

  // The bytes of the file that `render scene.cli ARGUMENTS -o FILE` writes.
  std::string bytes_of(const std::string& arguments) const {
    EXPECT_EQ(shell("$P render scene.cli --quiet -o direct.png " + arguments).exit_code, 0);
    return content_of(path("direct.png"));
  }
};

TEST_F(Pipe, BringsAScene) {
  put_content(path("ball.cli"), "sphere 1 0 0 -5\n");
  put_content(scene_, "image_size 8 6\nlight 0 9 9 1 1 1\nread ball.cli\nrender\n");
  EXPECT_EQ(shell("cat scene.cli | $P render - --quiet").exit_code, 0);
  EXPECT_EQ(shell("$P compare stdin.png stdin.png && $P render scene.cli --quiet && $P compare scene.png stdin.png")
                .exit_code,
            0);
  const ProgramResult check = shell("$P check - < scene.cli");
  EXPECT_NE(check.output.find("read: <stdin>\nread: ball.cli\n"), std::string::npos) << check.output;
}

TEST_F(Pipe, BringsAnAnimation) {
  put_content(scene_, small + "sphere {1 + t} 0 0 -5\n");
  ASSERT_EQ(
      shell("$P render scene.cli --frames 0-2 --quiet -o a.exr; $P render - --frames 0-2 --quiet -o b.exr < scene.cli")
          .exit_code,
      0);
  EXPECT_EQ(shell("for i in 0 1 2; do $P compare a.000$i.exr b.000$i.exr || exit 1; done").exit_code, 0);
}

TEST_F(Pipe, ErrorsNameTheirPlaceInIt) {
  const ProgramResult result = shell("printf 'light 0 9 9 1 1 1\\nspere 1\\n' | $P render -");
  EXPECT_EQ(result.exit_code, 65);
  EXPECT_NE(result.output.find("<stdin>:2:1: error"), std::string::npos) << result.output;
  EXPECT_EQ(shell("$P render - -o a.png < .").exit_code, 66);
  EXPECT_EQ(shell("$P render - -o a.png <&-").exit_code, 66);
  EXPECT_EQ(shell("echo 'read -' | $P check -").exit_code, 65) << "only the scene itself is standard input";
}

TEST_F(Pipe, TakesThePictureAndNothingElse) {
  const std::string expected = bytes_of("");
  ASSERT_EQ(expected.substr(1, 3), "PNG");
  EXPECT_EQ(shell("$P render scene.cli -o - > out 2> said").exit_code, 0);
  EXPECT_EQ(content_of(path("out")), expected);
  EXPECT_NE(content_of(path("said")).find("8x6 pixels"), std::string::npos);
  put_content(scene_, small + "reset_timer\nrender\nprint_timer\nrender\n");
  EXPECT_EQ(shell("$P render scene.cli -o - 2> said | cat > out").exit_code, 0);
  EXPECT_NE(content_of(path("said")).find("seconds: "), std::string::npos);
  EXPECT_EQ(content_of(path("out")), expected + expected) << "several pictures follow one another";
}

TEST_F(Pipe, TakesAMergedPicture) {
  const std::string expected = bytes_of("");
  EXPECT_EQ(shell("$P render scene.cli --shard 0/1 -o part.exr --quiet && $P merge part.exr -o - > out").exit_code, 0);
  EXPECT_EQ(content_of(path("out")), expected);
}

TEST_F(Pipe, ThatNobodyReadsIsAnError) {
  EXPECT_EQ(shell("(sleep 0.3; $P render scene.cli -o - 2> said; echo $? > code) | true; cat code").output, "74\n");
  EXPECT_NE(content_of(path("said")).find("Broken pipe"), std::string::npos);
}

TEST_F(Pipe, IsRefusedWhereFilesAreNeeded) {
  EXPECT_EQ(shell("$P render scene.cli --frames 0-1 --video a.mp4 -o -").exit_code, 64);
  EXPECT_EQ(shell("$P render scene.cli --shard 0/2 -o -").exit_code, 64);
  EXPECT_EQ(shell("$P render scene.cli --aov depth -o -").exit_code, 64);
  EXPECT_EQ(shell("$P farm submit - -o a.png --dry-run").exit_code, 64);
  EXPECT_EQ(shell("$P farm submit scene.cli -o - --dry-run").exit_code, 64);
  EXPECT_EQ(others(), Words{});
}

}  // namespace
}  // namespace penumbra::test
