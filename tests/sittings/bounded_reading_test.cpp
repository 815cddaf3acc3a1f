// Pipes, devices and endless files where a file is expected: one sentence at once, not a wait or a full memory.
#include <sys/stat.h>

#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

class BoundedReading : public SittingTest {
 protected:
  BoundedReading() {
    ::mkfifo(path("pipe").c_str(), 0600);
    ::mkfifo(path("pipe.cli").c_str(), 0600);
    ::mkfifo(path("pipe.previous").c_str(), 0600);
    std::filesystem::create_symlink("/dev/zero", path("zero"));
    put_content(path("huge"), "");
    std::filesystem::resize_file(path("huge"), std::uintmax_t{1} << 42);
  }
  int code_of(const std::string& command) {
    result_ = shell(command);
    return result_.exit_code;
  }

  ProgramResult result_;
};

TEST_F(BoundedReading, OfPicturesPartsAndCheckpoints) {
  ASSERT_EQ(render({"--shard", "0/2", "-o", path("part.exr")}), 0) << said();
  ASSERT_EQ(render({"-o", path("a.png")}), 0) << said();
  for (const std::string name : {"pipe", "zero", "/dev/stdin < /dev/zero"}) {
    EXPECT_EQ(code_of("$P compare a.png " + name), 4) << name;
    EXPECT_NE(result_.output.find("it is not a regular file"), std::string::npos) << result_.output;
    EXPECT_EQ(code_of("$P merge -o b.png part.exr " + name), 66) << result_.output;
    EXPECT_EQ(code_of("$P render scene.cli -o b.png --resume --checkpoint " + name), 73) << result_.output;
  }
  EXPECT_EQ(code_of("$P compare a.png huge"), 4) << result_.output;
  EXPECT_EQ(code_of("$P merge -o b.png part.exr huge"), 65) << result_.output;
  EXPECT_EQ(code_of("$P render scene.cli -o b.png --resume --checkpoint huge"), 65) << result_.output;
  std::filesystem::rename(path("pipe.previous"), path("b.ckpt.previous"));
  EXPECT_EQ(code_of("$P render scene.cli -o b.png --resume --checkpoint b.ckpt"), 73) << result_.output;
}

TEST_F(BoundedReading, OfScenes) {
  for (const std::string scene : {"pipe.cli", "zero", ".", "huge", "- < /dev/zero", "- < ."}) {
    for (const std::string command : {"check ", "render -o b.png "}) {
      EXPECT_EQ(code_of("$P " + command + scene), 66) << result_.output;
      EXPECT_EQ(result_.output.find('\n'), result_.output.size() - 1) << result_.output;
    }
  }
  for (const std::string line : {"read pipe", "mesh pipe", "read zero", "mesh zero", "mesh huge", "read ."}) {
    put_content(scene_, line + "\n");
    EXPECT_EQ(code_of("$P check scene.cli"), 65) << line;
    EXPECT_NE(result_.output.find("scene.cli:1:6: error: cannot read `"), std::string::npos) << result_.output;
  }
}

}  // namespace
}  // namespace penumbra::test
