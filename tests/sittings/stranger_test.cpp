// A scene from a stranger reaches no files but those beside it, whichever command reads it.
#include <sys/stat.h>

#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

namespace fs = std::filesystem;

class Stranger : public SittingTest {
 protected:
  Stranger() {
    for (const char* folder : {"work", "other"}) fs::create_directory(folder_ / folder);
    put_content(path("other/part.cli"), "root:secret\n");
    put_content(path("other/ball.cli"), "sphere 1 0 0 -4\n");
    put_content(path("work/s.cli"), "image_size 8 6\nlight 0 9 9 1 1 1\nsphere 1 0 0 -5\n");
    put_content(path("work/reads.cli"), "image_size 8 6\nlight 0 9 9 1 1 1\nread ../other/ball.cli\n");
    put_content(path("work/steals.cli"), "light 0 9 9 1 1 1\nread ../other/part.cli\n");
  }
  // The exit code of a command in the folder `work`.
  int code_of(const std::string& command) {
    result_ = shell_in(path("work"), command);
    return result_.exit_code;
  }

  ProgramResult result_;
};

TEST_F(Stranger, ReadsNothingElsewhere) {
  for (const std::string command : {"check steals.cli", "render steals.cli -o a.png", "check - < steals.cli",
                                    "render - -o a.png < steals.cli", "farm submit steals.cli -o a.png --dry-run"}) {
    EXPECT_EQ(code_of("$P " + command), 65) << command;
    EXPECT_NE(result_.output.find("--allow-paths"), std::string::npos) << result_.output;
    EXPECT_EQ(result_.output.find("root"), std::string::npos) << result_.output;
  }
  for (const std::string command :
       {"check reads.cli --allow-paths", "render reads.cli -o a.png --allow-paths", "check --allow-paths - < reads.cli",
        "farm submit reads.cli -o a.png --dry-run --allow-paths && grep -q allow-paths a.png.farm/shard.sh"}) {
    EXPECT_EQ(code_of("$P " + command), 0) << command << result_.output;
  }
}

TEST_F(Stranger, WritesNothingElsewhere) {
  for (const char* link : {"s.png", "a.0000.png"})
    fs::create_symlink("../other/" + std::string(link), folder_ / "work" / link);
  put_content(path("work/writes.cli"), content_of(path("work/s.cli")) + "write a.png\n");
  EXPECT_EQ(code_of("$P render s.cli"), 73) << result_.output;
  EXPECT_EQ(code_of("$P render writes.cli --frames 0-0"), 73) << result_.output;
  EXPECT_FALSE(fs::exists(path("other/s.png")) || fs::exists(path("other/a.0000.png")));
  EXPECT_EQ(code_of("$P render s.cli -o ../other/own.png"), 0) << "what the user names may be anywhere";
  EXPECT_EQ(code_of("$P render s.cli --allow-paths"), 0);
  EXPECT_TRUE(fs::exists(path("other/s.png")));
  EXPECT_EQ(code_of("cd ../other && $P render ../work/writes.cli --quiet"), 0) << "the working folder is in reach";
  EXPECT_TRUE(fs::exists(path("other/a.png")));
}

TEST_F(Stranger, UnreadableSceneIsNoInput) {
  ::mkfifo(path("work/pipe.cli").c_str(), 0600);
  for (const std::string scene : {"pipe.cli", "none.cli", "."}) {
    for (const std::string command : {"check ", "render ", "farm submit --dry-run -o a.png "}) {
      EXPECT_EQ(code_of("$P " + command + scene), 66) << command << scene << result_.output;
    }
  }
  if (!fs::exists(fs::path(PENUMBRA_PROGRAM).parent_path() / "penumbra-view")) GTEST_SKIP() << "built without a window";
  for (const std::string scene : {"pipe.cli", "none.cli"}) {
    EXPECT_EQ(code_of("DISPLAY= WAYLAND_DISPLAY= $P view " + scene), 66) << scene << result_.output;
  }
}

}  // namespace
}  // namespace penumbra::test
